#include <sphonic/plugin/kernel.hpp>

/// Wendland C2 (Dehnen and Aly 2012), support 2h. With s = 1 - q/2, cut at zero:
///   w(q) = s^3 (1 + 3q/2) in one dimension,  s^4 (1 + 2q) in two and three.
struct WendlandC2 {
    static constexpr double support() { return 2; }
    static constexpr double sigma(int dim) { return dim == 1 ? 5. / 8 : dim == 2 ? 7 / (4 * pi) : 21 / (16 * pi); }
    static constexpr double w(double q, int dim) {
        const double s = plus(1 - q / 2);
        return s * s * s * (dim == 1 ? 1 + 1.5 * q : s * (1 + 2 * q));
    }
    static constexpr double dw(double q, int dim) {
        const double s = plus(1 - q / 2);
        return -q * s * s * (dim == 1 ? 3 : 5 * s);
    }
    static constexpr abi::KernelProperties properties() { return {.positive_definite = true}; }
};

SPHONIC_KERNEL("wendland_c2", WendlandC2, dimensions(1, 2, 3),
               "Wendland C2, support 2h: positive definite, so particles do not pair")
