#include <sphonic/plugin/kernel.hpp>

/// Wendland C6 (Dehnen and Aly 2012), support 2h. With s = 1 - q/2, cut at zero:
///   w(q) = s^7 (1 + 7q/2 + 19q^2/4 + 21q^3/8) in one dimension,  s^8 (1 + 4q + 25q^2/4 + 4q^3) in two and three.
struct WendlandC6 {
    static constexpr double support() { return 2; }
    static constexpr double sigma(int dim) {
        return dim == 1 ? 55. / 64 : dim == 2 ? 39 / (14 * pi) : 1365 / (512 * pi);
    }
    static constexpr double w(double q, int dim) {
        const double s = plus(1 - q / 2);
        return sixth(s) * s *
               (dim == 1 ? 1 + q * (3.5 + q * (4.75 + 2.625 * q)) : s * (1 + q * (4 + q * (6.25 + 4 * q))));
    }
    static constexpr double dw(double q, int dim) {
        const double s = plus(1 - q / 2);
        return -q * sixth(s) * (dim == 1 ? 4.5 + q * (13.5 + 13.125 * q) : s * (5.5 + q * (19.25 + 22 * q)));
    }
    static constexpr abi::KernelProperties properties() { return {.positive_definite = true}; }

private:
    static constexpr double sixth(double x) { return x * x * x * (x * x * x); }
};

SPHONIC_KERNEL("wendland_c6", WendlandC6, dimensions(1, 2, 3),
               "Wendland C6, support 2h: positive definite, the smoothest of the three; wants many neighbours")
