#pragma once
#include <vector>

#include "frozen_weights.hpp"

namespace sphonic {

/// A viscosity on a set that will not move, du_i/dt = -sum_j m_j Pi_ij grad_i W_ij, by the weights w_ij = V grad_i W_ij that gradients
/// use: r_ij is q_ij w_ij with a kept q_ij = 1 / (V W'/r), and the sum is -rho0 sum_j Pi_ij w_ij.
class FrozenViscosity {
public:
    FrozenViscosity(const PairSet& set, FrozenWeightStore& weights, const Term& term, std::vector<int> target);
    /// Takes over the velocities of an evaluation, before any rates of it.
    void fill(const Evaluation& e);
    /// Adds to the rates of particles begin ... end - 1.
    void apply(const Evaluation& e, long begin, long end) const;

private:
    const PairSet& set_;
    const Term& term_;
    const FrozenWeights& weights_;
    const double* separation_;
    std::vector<int> target_;
    int velocity_;
    Interleaved velocities_;    ///< a pair finds all of j's components in one place

    static constexpr long most_pairs = 512;    ///< of one call of the plugin

    template <int D>
    void apply_in(const Evaluation& e, long begin, long end) const;
    template <int D>
    void apply_tile(const Evaluation& e, long begin, long end) const;
};

}    // namespace sphonic
