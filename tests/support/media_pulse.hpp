#pragma once
#include "scene.hpp"

/// Pulses from one medium into another.
namespace sphonic::testing::media {

/// rho and c of the second medium over the first.
struct Ratio {
    double rho, c;

    double impedance() const { return rho * c; }
    double reflection() const { return (impedance() - 1) / (impedance() + 1); }
};

inline constexpr double dx = 0.01, sigma = 16 * dx, start = -1.25, interface = 0.5 * dx, until = 2.25;

inline double pulse(double s) { return std::exp(-s * s / (2 * sigma * sigma)); }
inline std::string number(double x) { return Json(x).dump(); }

/// A Gaussian pulse of p and u that sets out rightwards in the first medium, along x in any dimension.
inline std::string pulse_into(const Ratio& ratio, int dimension = 1) {
    const bool plane = dimension == 2;
    const std::string f = "exp(-(x - " + number(start) + ")^2/(2*" + number(sigma) + "^2))", far = number(std::ceil(5 + 5 * ratio.c));
    return R"json({"dimension": )json" + std::to_string(dimension) + R"json(,
        "medium": [{"c0": 1, "rho0": 1}, {"region": "x > 0.5*dx", "c0": )json" + number(ratio.c) + R"json(, "rho0": )json" + number(ratio.rho) + R"json(}],
        "particles": {"type": "lattice", "dx": 0.01, "lower": [-5)json" + (plane ? ", 0" : "") + R"json(], "upper": [)json" + far + (plane ? ", 0.2" : "") + R"json(]},
        "boundaries": [{"type": "periodic", "face": "all"}], "kernel": {"type": "cubic_spline", "h_over_dx": 1.2}, "equations": "acoustics",
        "initial": {"p": ")json" + f + R"json(", "u": [")json" + f + '"' + (plane ? ", \"0\"" : "") + R"json(]},
        "integrator": {"type": "leapfrog", "courant": 0.7}, "until": )json" + number(until) + "}";
}

/// What comes back and what goes on, by projection of the last state on the exact pulses.
struct Passed {
    double reflected, transmitted, grown;    ///< the last: energy over that at the start
};
inline Passed passed(const Ratio& ratio, const std::vector<std::string>& set, int dimension = 1) {
    const Case c = scene(pulse_into(ratio, dimension), set);
    Simulation simulation(c);
    simulation.run();
    const Profile now = simulation.profile();
    double back = 0, back_norm = 0, on = 0, on_norm = 0;
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        const double s = now.x[0][i] - interface, travelled = until + start - interface;
        if (std::abs(now.x[0][i]) > 4.5 * std::max(1.0, ratio.c)) continue;    // the box is periodic
        double& sum = s < 0 ? back : on;
        double& norm = s < 0 ? back_norm : on_norm;
        const double shape = s < 0 ? pulse(-s - travelled) : pulse(s / ratio.c - travelled);
        sum += shape * now.p[i];
        norm += shape * shape;
    }
    return {back / back_norm, on / on_norm, simulation.summary().energy_final / simulation.summary().energy_initial};
}

}    // namespace sphonic::testing::media
