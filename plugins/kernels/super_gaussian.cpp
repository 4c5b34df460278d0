#include <sphonic/plugin/kernel.hpp>

/// Super-Gaussian (Monaghan and Gingold 1983): w(q) = (d/2 + 1 - q^2) exp(-q^2). Uncut its second moment is zero: it
/// smooths with an error of order h^4. It is negative from q = sqrt(d/2 + 1) on, rises from sqrt(d/2 + 2) on, and is cut
/// at q = cutoff, where the negative tail has not quite vanished:
/// cut at 3 it integrates to 1.000187 / 1.000987 / 1.003320 in one, two and three dimensions.
struct SuperGaussian {
    double cutoff = 3;

    static constexpr auto parameters() {
        return std::array{
            real("cutoff", &SuperGaussian::cutoff, "1", 1, 10, "radius in units of h beyond which W is zero")};
    }

    double support() const { return cutoff; }
    static double sigma(int dim) { return std::pow(pi, -0.5 * dim); }
    static double w(double q, int dim) { return (0.5 * dim + 1 - q * q) * exp(-q * q); }
    static double dw(double q, int dim) { return -2 * q * (0.5 * dim + 2 - q * q) * exp(-q * q); }
    abi::KernelProperties properties() const {
        abi::KernelProperties claims{.non_negative = false, .monotone = false};
        for (int d = 1; d <= 3; ++d) claims.mass_defect[d] = 1 - mass(d);
        return claims;
    }

private:
    /// Integral inside the cut-off c: that of the Gaussian, and c^d exp(-c^2) / Gamma(d/2).
    double mass(int dim) const {
        const double c = cutoff, tail = exp(-c * c);
        if (dim == 1) return std::erf(c) + c / std::sqrt(pi) * tail;
        if (dim == 2) return 1 + (c * c - 1) * tail;
        return std::erf(c) + 2 * c * (c * c - 1) / std::sqrt(pi) * tail;
    }
};

SPHONIC_KERNEL("super_gaussian", SuperGaussian, dimensions(1, 2, 3),
               "Super-Gaussian cut at a multiple of h: fourth order, partly negative")
