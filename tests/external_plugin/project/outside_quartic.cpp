#include <sphonic/plugin/kernel.hpp>

/// Lucy (1977): w(q) = (1 + 3q/2) (1 - q/2)^3, support 2h, here from a project of its own.
struct OutsideQuartic {
    static constexpr double support() { return 2; }
    static constexpr double sigma(int dim) { return dim == 1 ? 5. / 8 : dim == 2 ? 5 / (4 * pi) : 105 / (128 * pi); }
    static constexpr double w(double q) {
        const double a = plus(1 - q / 2);
        return (1 + 1.5 * q) * a * a * a;
    }
    static constexpr double dw(double q) {
        const double a = plus(1 - q / 2);
        return -3 * q * a * a;
    }
};

SPHONIC_KERNEL("outside_quartic", OutsideQuartic, dimensions(1, 2, 3), "Lucy's quartic, built outside sphonic's tree")
