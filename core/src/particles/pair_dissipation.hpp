#pragma once
#include <vector>

#include "pair_correction.hpp"

namespace sphonic {

/// A dissipation of one variable by packed pairs, in two passes over the tiles: the corrected gradients of its components, then the
/// sums over pairs. Between them virtual particles take the gradients of their sources.
class PairDissipation {
public:
    /// `corrections` of the term's kernel, computed before each `apply`.
    PairDissipation(const PairSet& set, const Term& term, const PairCorrections& corrections);
    /// Adds to the rates; `inverse_rho` of all particles where the set has a current density, else null.
    void apply(const Evaluation& e, const double* inverse_rho);

private:
    /// A thread's share of the tiles.
    struct Worker {
        PairValues values, all;    ///< packing the components; and their gradients too
        PairTile tile{};
        CorrectedSeparations corrected{};
        Array pair{}, coupling{}, volume{};
    };
    const PairSet& set_;
    const Term& term_;
    const PairCorrections& corrections_;
    int first_, components_;
    std::vector<Array> gradient_;          ///< of component c along axis a at c d + a
    std::vector<const double*> state_;     ///< that the fields are filled from: the components, then the gradients
    PairFields fields_, all_;              ///< the components; and their gradients too
    std::vector<Worker> workers_;

    int at(int component, int axis) const { return component * set_.scene.box.dimension + axis; }
    void for_tiles(auto visit);
    void take_gradients(Worker& worker);
    void add_sums(Worker& worker, const Evaluation& e, bool current_density);
    const double* couplings(Worker& worker, bool current_density);
};

}    // namespace sphonic
