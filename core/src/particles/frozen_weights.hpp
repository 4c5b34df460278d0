#pragma once
#include <map>
#include <utility>

#include "pair_set.hpp"

namespace sphonic {

/// Weights of all pairs of a set that will not move, for a gradient or a divergence: f_i takes `own`, the sum over the row,
/// and f_j takes `other`. Both are V_j grad_i W_ij, corrected where the form asks for it.
struct FrozenWeights {
    Array own[3];      ///< by axis and particle [1/m]
    Array other[3];    ///< by axis and pair [1/m]
};

/// The weights of a set, computed when first asked for and shared by all terms of one kernel and correction.
class FrozenWeightStore {
public:
    explicit FrozenWeightStore(const PairSet& set) : set_(set) {}
    const FrozenWeights& of(int kernel, abi::Correction correction);
    double bytes() const;

private:
    const PairSet& set_;
    std::map<std::pair<int, abi::Correction>, FrozenWeights> known_;
};

/// In frozen_program.cpp.
std::unique_ptr<Program> make_frozen_program(const PairSet& set, FrozenWeightStore& weights, const std::vector<int>& variables);

}    // namespace sphonic
