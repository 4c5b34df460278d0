#pragma once

namespace sphonic::abi {

/// Densities [kg/m^3] of the two particles of each of n pairs, and their inverses, which cost a division less.
struct PairMedia {
    int n = 0;
    const double *rho_i = nullptr, *rho_j = nullptr;
    const double *inverse_rho_i = nullptr, *inverse_rho_j = nullptr;
};

/// How a gradient or a divergence weighs the two values of a pair:
///   sum_j V_j (own_ij f_i + other_ij f_j) grad_i W_ij      (dot product for a divergence).
/// The form decides what is conserved and what converges.
class Form {
public:
    static constexpr const char* kind = "form";
    virtual ~Form() = default;

    /// True when the two coefficients are the same for every pair and every medium; they are then asked for once.
    virtual bool uniform() const = 0;
    virtual void coefficients(const PairMedia& media, double* own, double* other) const = 0;
};

}    // namespace sphonic::abi
