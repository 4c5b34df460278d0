#pragma once
#include <vector>

#include "frozen_weights.hpp"

namespace sphonic {

/// A dissipation of one variable on a set that will not move, in two passes: the corrected gradients of its components, by rows of
/// constant weights, then the sums over pairs. Between them virtual particles take the gradients of their sources.
class FrozenDissipation {
public:
    FrozenDissipation(const PairSet& set, FrozenWeightStore& weights, const Term& term);
    /// Adds to the rates.
    void apply(const Evaluation& e);

private:
    const PairSet& set_;
    const FrozenWeights& weights_;
    const double* coupling_;
    double strength_;
    int first_, components_;
    std::vector<Array> gradient_[3];    ///< by axis and component

    void gradients(const Evaluation& e, long begin, long end);
    void sums(const Evaluation& e, long begin, long end) const;
    template <int D>
    void gradients_in(const Evaluation& e, long begin, long end);
    template <int D>
    void sums_in(const Evaluation& e, long begin, long end) const;
};

}    // namespace sphonic
