#include <sphonic/plugin/kernel.hpp>

/// Quintic B-spline (Morris 1996):  w(q) = (3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5, each power cut at zero.
/// The 3-D constant is 1/(120 pi); the 3/(359 pi) found in print integrates to 1.002786.
struct QuinticSpline {
    static constexpr double support() { return 3; }
    static constexpr double sigma(int dim) { return dim == 1 ? 1. / 120 : dim == 2 ? 7 / (478 * pi) : 1 / (120 * pi); }
    static constexpr double w(double q) {
        return fifth(plus(3 - q)) - 6 * fifth(plus(2 - q)) + 15 * fifth(plus(1 - q));
    }
    static constexpr double dw(double q) {
        return -5 * fourth(plus(3 - q)) + 30 * fourth(plus(2 - q)) - 75 * fourth(plus(1 - q));
    }

private:
    static constexpr double fourth(double x) { return x * x * x * x; }
    static constexpr double fifth(double x) { return fourth(x) * x; }
};

SPHONIC_KERNEL("quintic_spline", QuinticSpline, dimensions(1, 2, 3),
               "Quintic B-spline, support 3h: smoother and dearer than the cubic")
