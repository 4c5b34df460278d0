#pragma once
#include <map>
#include <string>

#include "pair_set.hpp"
#include "stencil.hpp"

namespace sphonic {

/// Weights of all pairs of a set that will not move, for a gradient or a divergence: f_i takes `own`, the sum over the row,
/// and f_j takes `other`. Both are V_j grad_i W_ij, corrected where the form asks for it, and times the form's coefficients
/// where those differ from pair to pair.
struct FrozenWeights {
    Array own[3];      ///< by axis and particle [1/m]
    Array other[3];    ///< by axis and pair [1/m]
};

/// The weights of a set, computed when first asked for and shared by all terms that can.
class FrozenWeightStore {
public:
    explicit FrozenWeightStore(const PairSet& set) : set_(set) {}
    /// Without the coefficients of any form.
    const FrozenWeights& of(int kernel, abi::Correction correction);
    const FrozenWeights& of(const Term& term);
    /// True where the coefficients are not the same for all pairs: between several media.
    bool holds_coefficients(const Term& term) const { return set_.media.several() && !term.form->uniform(); }
    double bytes() const;

private:
    const PairSet& set_;
    std::map<std::string, FrozenWeights> known_;

    FrozenWeights weigh(int kernel, abi::Correction correction, const std::vector<RestCoefficients>& between) const;
};

/// In frozen_program.cpp.
std::unique_ptr<Program> make_frozen_program(const PairSet& set, FrozenWeightStore& weights, const std::vector<int>& variables);

}    // namespace sphonic
