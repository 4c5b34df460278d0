#include <sphonic/plugin/kernel.hpp>

/// Cubic B-spline (Monaghan and Lattanzio 1985):
///   w(q) = 2/3 - q^2 + q^3/2  (q < 1),  (2 - q)^3 / 6  (q < 2),
/// written with non-negative parts. Its Fourier transform changes sign: moving particles with many neighbours pair.
struct CubicSpline {
    static constexpr double support() { return 2; }
    static constexpr double sigma(int dim) { return dim == 1 ? 1 : dim == 2 ? 15 / (7 * pi) : 3 / (2 * pi); }
    static constexpr double w(double q) {
        const double a = plus(2 - q), b = plus(1 - q);
        return (a * a * a - 4 * b * b * b) / 6;
    }
    static constexpr double dw(double q) {
        const double a = plus(2 - q), b = plus(1 - q);
        return (4 * b * b - a * a) / 2;
    }
};

SPHONIC_KERNEL("cubic_spline", CubicSpline, dimensions(1, 2, 3),
               "Cubic B-spline, support 2h: the usual choice, few neighbours")
