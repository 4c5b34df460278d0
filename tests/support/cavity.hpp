#pragma once
/// Sound in a round cavity of radius 1 about the origin, and its exact modes.
#include <cmath>
#include <sstream>

#include "scene.hpp"

namespace sphonic::testing {

/// p = J_m(k r) cos(m angle) cos(k c0 t) in two dimensions, sin(k r)/(k r) cos(k c0 t) in three.
struct CavityMode {
    int dimension;
    std::string wall;
    int m;
    double k;    ///< [rad/m], J_m'(k) = 0 at a rigid wall, J_m(k) = 0 at a soft one; tan k = k, sin k = 0

    double operator()(const double* x) const {
        const double r = std::hypot(x[0], x[1], dimension > 2 ? x[2] : 0);
        if (dimension == 3) return r > 0 ? std::sin(k * r) / (k * r) : 1;
        return std::cyl_bessel_j(double(m), k * r) * std::cos(m * std::atan2(x[1], x[0]));
    }
    /// As an expression, of m = 0, 1, 2: by the power series of J_m, good to 1e-12 for k r < 8.
    std::string text() const {
        std::ostringstream out;
        out.precision(17);
        if (dimension == 3) {
            out << "sin(" << k << "*max(r,1e-9))/(" << k << "*max(r,1e-9))";
            return out.str();
        }
        out << (m == 0 ? "1" : m == 1 ? "x" : "(x^2-y^2)") << "*" << std::pow(0.5 * k, m) / std::tgamma(m + 1.0) << "*(";
        double factor = 1;
        for (int s = 0; s < 30; ++s) {
            out << (s ? "+r*r*(" : "") << factor;
            factor = -0.25 * k * k / ((s + 1.0) * (s + 1.0 + m)) * factor;
        }
        out << std::string(29, ')') << ")";
        return out.str();
    }
};

inline const CavityMode rigid_mode{2, "rigid", 2, 3.0542369282271404}, soft_mode{2, "soft", 1, 3.8317059702075125},
    rigid_ball{3, "rigid", 0, 4.493409457909064}, soft_ball{3, "soft", 0, 3.141592653589793};

/// n spacings to the radius, on a lattice that the cavity does not know of; c0 = 2. Sound at rest but for `p`.
inline std::string cavity(int dimension, const std::string& wall, int n, const std::string& p, double until) {
    std::string lower, upper;
    const double dx = 1.0 / n, offset[] = {0.13, 0.29, 0.41};
    for (int a = 0; a < dimension; ++a) {
        lower += (a ? "," : "") + Json(-1 - (8 - offset[a]) * dx).dump();
        upper += (a ? "," : "") + Json(1 + 9 * dx).dump();
    }
    return R"({"dimension": )" + std::to_string(dimension) + R"(, "medium": {"c0": 2, "rho0": 1.5},
        "particles": {"type": "lattice", "dx": )" + Json(dx).dump() + R"(, "lower": [)" + lower + R"(], "upper": [)" + upper + R"(]},
        "kernel": {"type": "cubic_spline", "h_over_dx": 1.05}, "equations": "corrected_acoustics",
        "obstacles": [{"type": "circle", "radius": 1, "wall": ")" + wall + R"(", "keep": "inside"}],
        "initial": {"p": ")" + p + R"("}, "integrator": {"type": "leapfrog", "courant": 0.5}, "until": )" + Json(until).dump() + "}";
}

/// Relative L2 error of the pressure after so many periods of a mode.
inline double mode_error(const CavityMode& mode, int n, double periods, const std::vector<std::string>& set = {}) {
    const double until = periods * 2 * pi / (2 * mode.k);
    const Case c = scene(cavity(mode.dimension, mode.wall, n, mode.text(), until), set);
    Simulation simulation(c);
    simulation.run();
    const Profile now = simulation.profile();
    const double phase = std::cos(2 * mode.k * now.t);
    double squares = 0, norm = 0;
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        const double x[3] = {now.x[0][i], now.x[1][i], mode.dimension > 2 ? now.x[2][i] : 0}, p = mode(x) * phase;
        squares += (now.p[i] - p) * (now.p[i] - p);
        norm += p * p;
    }
    return std::sqrt(squares / norm);
}

}    // namespace sphonic::testing
