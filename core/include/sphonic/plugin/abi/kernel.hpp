#pragma once

namespace sphonic::abi {

/// Declared properties: the contract tests hold a kernel to each one that it claims.
struct KernelProperties {
    bool non_negative = true;
    bool monotone = true;
    bool positive_definite = false;    ///< Fourier transform >= 0 in every dimension claimed: no pairing instability
    double mass_defect[4] = {0, 0, 0, 0};    ///< 1 - integral of W in dimension [d], where a cut-off keeps it from zero
};

/// A smoothing kernel W(r, h) = sigma_d / h^d w(r / h), evaluated in blocks.
class Kernel {
public:
    static constexpr const char* kind = "kernel";
    virtual ~Kernel() = default;

    /// W [m^-d] and (dW/dr) / r [m^-(d+2)] at n distances r [m]; either output may be null.
    /// Both are zero at and beyond the support; dW_over_r is 0 at r = 0.
    virtual void evaluate(int d, int n, const double* r, double h, double* W, double* dW_over_r) const = 0;

    /// Radius of the support in units of h.
    virtual double support() const = 0;
    virtual bool defined(int d) const = 0;
    virtual KernelProperties properties() const = 0;
};

}    // namespace sphonic::abi
