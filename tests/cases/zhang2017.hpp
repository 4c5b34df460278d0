#pragma once
/// The tone of Zhang, Li and Zhang (2017) on a set: what theory says that the set makes of it, and runs beside that.
#include <map>

#include <sphonic/prediction.hpp>
#include <sphonic/stability.hpp>

#include "../support/scene.hpp"
#include "../support/waves.hpp"

namespace sphonic::testing::zhang2017 {

inline constexpr double c0 = 340, omega = 340, k = 1, inflow = -50;    ///< of the published tone
inline const std::string folder = std::string(SPHONIC_SOURCE_DIR) + "/cases/zhang2017/";

inline Case zhang(const std::string& name, const std::vector<std::string>& set = {}) {
    return repository_case("zhang2017/" + name, set);
}
inline std::string number(double x) { return Json(x).dump(); }
inline std::string spacing(double dx) { return "/particles/dx=" + number(dx); }
inline std::string velocity(const std::vector<std::string>& components) { return "/initial/u=" + Json(components).dump(); }
inline std::string courant(double C) { return "/integrator/courant=" + number(C); }

/// The tone on an infinite set: exact at t = 0 everywhere and for all time at the inflow. What started as the initial wave has
/// the set's frequency at the wave number k, what came in later the set's wave number at the frequency omega.
struct Tone {
    double late, short_by;    ///< [rad/s] omega less the set's frequency, [rad/m] the set's wave number less k
    double group;             ///< [m/s]
    double t, start;          ///< end of the run [s], last imposed particle [m]

    Tone(const Case& c, double dt) : t(c.until), start(inflow + 3 * c.box.dx) {
        const double along[3] = {1, 0, 0}, e = 1e-4;
        const auto frequency = [&](double at) { return travelling_mode(c, at, along, dt, undamped).omega; };
        late = omega - frequency(k);
        short_by = root_between(0.5 * k, 2 * k, [&](double at) { return frequency(at) - omega; }) - k;
        group = (frequency(k + e) - frequency(k - e)) / (2 * e);
    }
    /// Phase by which it is behind after a way s from the inflow.
    double lag(double s) const { return s < group * t ? short_by * s : late * t; }
    /// What the set should have where the exact wave is A [sin(omega t - k x) + R sin(omega t + k x - 2 k wall)], A = 1 Pa.
    double pressure(double x, double R, double wall) const {
        return std::sin(omega * t - k * x - lag(x - start)) +
               R * std::sin(omega * t + k * x - 2 * k * wall - lag(2 * wall - x - start));
    }
};

/// A run beside theory: L and M of both, and where they differ most, over the reference's region.
struct Beside {
    double L = 0, M = 0, L_theory = 0, M_theory = 0, apart = 0;
    double smooth = 0;    ///< the same, mean of two neighbours along a line
    double across = 0;    ///< differences between particles of one x
    bool diverged = false;
};
inline Beside beside_theory(const Case& c, double R = 0, double wall = 0) {
    Simulation simulation(c);
    simulation.run();
    if (simulation.summary().diverged) return {.diverged = true};
    const Tone tone(c, simulation.summary().dt);
    const Profile now = simulation.profile();
    Beside b;
    double squares = 0, theory = 0, norm = 0, last = std::nan("");    // none yet
    std::map<long, double> first;                                     // of each x
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        if (!now.in_region[i]) continue;
        const double predicted = tone.pressure(now.x[0][i], R, wall), e = predicted - now.exact[i];
        squares += std::pow(now.p[i] - now.exact[i], 2), theory += e * e, norm += std::pow(now.exact[i], 2);
        b.M_theory = std::max(b.M_theory, std::abs(e));
        b.apart = std::max(b.apart, std::abs(now.p[i] - predicted));
        b.smooth = std::max(b.smooth, 0.5 * std::abs(now.p[i] - predicted + last));
        last = now.p[i] - predicted;
        const double beside = first.emplace(std::lround(now.x[0][i] / c.box.dx), now.p[i]).first->second;
        b.across = std::max(b.across, std::abs(now.p[i] - beside));
    }
    b.L = simulation.summary().errors->l2, b.M = simulation.summary().errors->max;
    b.L_theory = std::sqrt(theory / norm);
    CHECK(b.L == Approx(std::sqrt(squares / norm)).epsilon(1e-9));
    return b;
}

}    // namespace sphonic::testing::zhang2017
