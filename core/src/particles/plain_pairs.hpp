#pragma once
#include <optional>

#include "pair_set.hpp"

namespace sphonic {

/// The rates of sound in one medium at rest, whose pairs all have the same coefficients:
///   du_i/dt = coefficient sum_j V (own p_i + other p_j) grad_i W_ij - sum_j m Pi_ij grad_i W_ij,
///   dp_i/dt = coefficient sum_j V (own u_i + other u_j) . grad_i W_ij,
/// or one of them. A pair's values are taken once and become one scalar for each sum.
struct PlainRates {
    struct Derivative {
        int target, operand;    ///< variables
        double own, other;
        double coefficient;     ///< with V [m^d]
    };
    std::optional<Derivative> gradient, divergence;
    const Term* viscosity = nullptr;    ///< of the gradient's target
    int kernel = 0;

    /// Those of `shares`, if they are of this kind.
    static std::optional<PlainRates> of(const PairSet& set, const std::vector<Share>& shares);
    /// The vector that is read, a variable; -1 for none.
    int vector() const { return viscosity ? viscosity->operand : divergence ? divergence->operand : -1; }

private:
    bool add(const PairSet& set, int target, const Term& term);
};

std::unique_ptr<Program> make_plain_program(const PairSet& set, const PlainRates& rates);

}    // namespace sphonic
