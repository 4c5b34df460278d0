#pragma once
#include <vector>

#include "pair_set.hpp"

namespace sphonic {

/// The matrices L_i that correct one kernel's gradient, of own and virtual particles. They are symmetric.
class PairCorrections {
public:
    PairCorrections(const PairSet& set, int kernel);
    /// For the present positions; `inverse_rho` of all particles where the set has a current density, else null.
    void compute(const double* inverse_rho);

    /// Some form takes L_j of a pair too.
    void pairwise() { pairwise_ = true; }
    bool is_pairwise() const { return pairwise_; }
    /// Row a, column b, by particle.
    const double* entry(int a, int b) const { return entry_[a < b ? at(a, b) : at(b, a)].data(); }

private:
    /// A thread's share of the tiles.
    struct Worker {
        PairValues pairs;
        PairTile tile{};
        long degenerate = -1, neighbours = 0;    ///< the first particle without a gradient, and how many it has
    };
    const PairSet& set_;
    int kernel_;
    bool pairwise_ = false;
    PairFields positions_;
    std::vector<Worker> workers_;
    Array entry_[6];

    static std::size_t at(int a, int b) { return std::size_t(b * (b + 1) / 2 + a); }
    void compute_tile(Worker& worker);
    template <int D>
    void compute_in(Worker& worker);
    void reflect();
    void reflect_in_faces();
    [[noreturn]] void refuse(long i, long neighbours) const;
};

/// L_i r_ij and L_j r_ij of a tile's pairs.
class CorrectedSeparations {
public:
    void start(const PairSet& set, const PairCorrections& corrections, const PairTile& tile, PairValues& pairs);
    const double* own(int axis) const { return own_[axis].data(); }
    const double* other(int axis) const { return other_[axis].data(); }

private:
    Array own_[3], other_[3];
};

}    // namespace sphonic
