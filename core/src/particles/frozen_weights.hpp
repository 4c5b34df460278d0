#pragma once
#include <map>
#include <string>

#include "cloud_weights.hpp"
#include "pair_set.hpp"
#include "row_runs.hpp"
#include "stencil.hpp"

namespace sphonic {

/// Weights of all pairs of a set that will not move, for a gradient or a divergence: f_i takes `own`, the sum over the row,
/// and f_j takes `other`. Both are V_j grad_i W_ij, corrected where the form asks for it, and times the form's coefficients
/// where those differ from pair to pair. A form that fits weights w_ij of its own has those in the place of V_j grad_i W_ij.
struct FrozenWeights {
    Array own[3];      ///< by axis and particle [1/m]
    Array other[3];    ///< by axis and pair [1/m]
    std::vector<RowRun> runs{};
};

/// The weights of a set, computed when first asked for and shared by all terms that can.
class FrozenWeightStore {
public:
    explicit FrozenWeightStore(const PairSet& set) : set_(set) {}
    /// Without the coefficients of any form.
    const FrozenWeights& of(int kernel, abi::Correction correction);
    const FrozenWeights& of(const Term& term);
    CloudWeightStore& cloud() { return cloud_; }
    const CloudWeightStore& cloud() const { return cloud_; }
    /// True where the coefficients are not the same for all pairs: between several media.
    bool holds_coefficients(const Term& term) const { return set_.media.several() && !term.form->uniform(); }
    /// a_ij of every pair at alpha = 1 [1/s]. In frozen_dissipation.cpp.
    const Array& of(const abi::Dissipation& dissipation, int kernel);
    /// 1 / (V (dW/dr)/r) of every pair [m^2], zero where the slope is. In frozen_viscosity.cpp.
    const Array& separations(int kernel);
    double bytes() const;

private:
    const PairSet& set_;
    std::map<std::string, FrozenWeights> known_;
    CloudWeightStore cloud_{set_};
    std::map<std::pair<const abi::Dissipation*, int>, Array> couplings_;
    std::map<int, Array> separations_;

    FrozenWeights sum_rows(const CloudWeights& fitted) const;
    FrozenWeights weigh(int kernel, abi::Correction correction, const std::vector<RestCoefficients>& between) const;
    void couple_by_medium(Array& a) const;
};

/// In frozen_program.cpp.
std::unique_ptr<Program> make_frozen_program(const PairSet& set, FrozenWeightStore& weights, const std::vector<int>& variables);

}    // namespace sphonic
