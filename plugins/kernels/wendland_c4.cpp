#include <sphonic/plugin/kernel.hpp>

/// Wendland C4 (Dehnen and Aly 2012), support 2h. With s = 1 - q/2, cut at zero:
///   w(q) = s^5 (1 + 5q/2 + 2q^2) in one dimension,  s^6 (1 + 3q + 35q^2/12) in two and three.
struct WendlandC4 {
    static constexpr double support() { return 2; }
    static constexpr double sigma(int dim) { return dim == 1 ? 3. / 4 : dim == 2 ? 9 / (4 * pi) : 495 / (256 * pi); }
    static constexpr double w(double q, int dim) {
        const double s = plus(1 - q / 2);
        return fourth(s) * s * (dim == 1 ? 1 + q * (2.5 + 2 * q) : s * (1 + q * (3 + 35. / 12 * q)));
    }
    static constexpr double dw(double q, int dim) {
        const double s = plus(1 - q / 2);
        return -q * fourth(s) * (dim == 1 ? 3.5 + 7 * q : s * (14 + 35 * q) / 3);
    }
    static constexpr abi::KernelProperties properties() { return {.positive_definite = true}; }

private:
    static constexpr double fourth(double x) { return x * x * x * x; }
};

SPHONIC_KERNEL("wendland_c4", WendlandC4, dimensions(1, 2, 3),
               "Wendland C4, support 2h: positive definite, smoother than C2, narrower at equal support")
