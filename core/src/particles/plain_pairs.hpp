#pragma once
#include <optional>

#include "pair_set.hpp"

namespace sphonic {

/// The rates of sound in one medium by forms without correction,
///   du_i/dt = coefficient rho_i^power sum_j V_j (own_ij p_i + other_ij p_j) grad_i W_ij - sum_j m Pi_ij grad_i W_ij,
///   dp_i/dt = coefficient rho_i^power sum_j V_j (own_ij u_i + other_ij u_j) . grad_i W_ij,
/// or one of them; volumes and forms are those of rest, or of the current density. A pair's values are taken once and become one
/// scalar for each sum.
struct PlainRates {
    struct Derivative {
        int target = 0, operand = 0;          ///< variables
        const abi::Form* by_pair = nullptr;   ///< gives own and other anew for each pair; null where they are the same for all
        double own = 1, other = 0;
        double coefficient = 0;               ///< with V at rest [m^d], or with the particles' mass [kg]
        int density_power = 0;
    };
    std::optional<Derivative> gradient, divergence;
    const Term* viscosity = nullptr;    ///< of the gradient's target
    int kernel = 0;
    int density = -1;                   ///< the variable of the current density; -1 at rest

    /// Those of `shares`, if they are of this kind.
    static std::optional<PlainRates> of(const PairSet& set, const std::vector<Share>& shares);
    /// The vector that is read, a variable; -1 for none.
    int vector() const { return viscosity ? viscosity->operand : divergence ? divergence->operand : -1; }
    /// Places in the state of what pairs read: the vector, the gradient's operand, the density.
    std::vector<int> components_read(const PairSet& set) const;

private:
    bool add(const PairSet& set, int target, const Term& term);
};

/// In plain_program.cpp.
std::unique_ptr<Program> make_plain_program(const PairSet& set, const PlainRates& rates);

}    // namespace sphonic
