#pragma once

namespace sphonic::abi {

/// Up to some thousands of packed pairs ij. c and the volume are uniform when their arrays are null.
struct DampedPairs {
    int n = 0;
    const double* r2 = nullptr;             ///< |r_ij|^2 [m^2], > 0
    const double* slope = nullptr;          ///< (dW/dr)/r [m^-(d+2)], zero at and beyond the support
    double h = 0, c = 0, volume = 0;        ///< smoothing length [m], the pair's sound speed [m/s], V_j [m^d]
    const double* c_each = nullptr;         ///< [m/s]
    const double* volume_each = nullptr;    ///< [m^d]
};

/// Damping of what a disordered set cannot carry, on p and each component of u:
///   df_i/dt += alpha sum_j a_ij [ f_j - f_i - (grad f_i + grad f_j)/2 . (x_j - x_i) ],
/// where the gradients are corrected ones (full matrix). The bracket vanishes for linear fields on any set and is of fourth order
/// in k dx for waves. The runtime takes the gradients and the sums; a plugin says how strongly two particles are coupled.
class Dissipation {
public:
    static constexpr const char* kind = "dissipation";
    virtual ~Dissipation() = default;

    /// a_ij [1/s] of each pair at alpha = 1: not negative, zero at and beyond the support, in proportion to c.
    virtual void couple(const DampedPairs& pairs, double* a) const = 0;

    /// alpha where a case gives none. `disorder` is the root mean square over particles and axes a of |l sum_j V_j d_a W_ij|, the kernel's
    /// derivative of a constant over its width l: 0 on a lattice, in 2-D 0.28 of a lattice's jitter [dx] for the cubic spline of h = 1.3 dx.
    virtual double strength(double disorder) const = 0;
};

}    // namespace sphonic::abi
