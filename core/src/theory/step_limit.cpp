#include <sphonic/stability.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "modes.hpp"

namespace sphonic {
namespace {

constexpr double tolerance = 1e-7;      ///< of |xi|: a double root on the unit circle splits by sqrt of round-off
constexpr double strict_least = 0.1;    ///< omega dt below which a limit counts as none
constexpr double weak_most = 1;         ///< omega dt up to which a weakly unstable integrator is trusted at all

/// Largest dt up to `end` for which `stable` holds from 0 on: climbs geometrically from `begin`, then bisects.
template <class Stable>
double last_stable(double begin, double end, Stable stable) {
    if (!stable(begin)) return 0;
    double low = begin, high = begin;
    while (high < end) {
        high = std::min(end, 1.15 * low);
        if (!stable(high)) break;
        low = high;
    }
    if (low >= end) return end;
    while (high - low > 1e-7 * high) {
        const double middle = 0.5 * (low + high);
        (stable(middle) ? low : high) = middle;
    }
    return low;
}

double limit_of(const Case& scene, const std::vector<Mode>& modes) {
    return last_stable(strict_least, 20, [&](double dt) { return worst_root(scene, modes, dt) <= 1 + tolerance; });
}

/// Few of the modes, to which the others are added that turn out to be worse.
std::vector<Mode> first_choice(const std::vector<Mode>& modes) {
    const auto faster = [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; };
    const auto milder = [](const Mode& a, const Mode& b) { return a.decay > b.decay; };
    return {*std::max_element(modes.begin(), modes.end(), faster), *std::max_element(modes.begin(), modes.end(), milder)};
}

/// The one that grows most at a step, with its |xi|.
std::pair<double, const Mode*> worst_of(const Case& scene, const std::vector<Mode>& modes, double dt) {
    std::pair<double, const Mode*> worst{0, nullptr};
    for (const Mode& mode : modes)
        if (const double root = worst_root(scene, {mode}, dt); root > worst.first) worst = {root, &mode};
    return worst;
}

/// `find`(chosen modes) gives a step that they bear; modes that do not are taken in, until all of them do.
template <class Find>
double borne_by_all(const Case& scene, const std::vector<Mode>& modes, Find find) {
    std::vector<Mode> chosen = first_choice(modes);
    for (;;) {
        const double dt = find(chosen);
        if (!(dt > 0) || modes.size() <= chosen.size()) return dt;
        const auto [root, worst] = worst_of(scene, modes, dt);
        if (root <= worst_root(scene, chosen, dt) * (1 + tolerance)) return dt;
        chosen.push_back(*worst);
    }
}

/// The step at which the worst mode grows by e^exponent within the run.
double step_of_growth(const Case& scene, const std::vector<Mode>& modes, double omega, double exponent) {
    return borne_by_all(scene, modes, [&](const std::vector<Mode>& chosen) {
        const auto grown = [&](double dt) { return scene.until / dt * std::log(worst_root(scene, chosen, dt)); };
        double least = strict_least / omega;
        while (least > 1e-9 / omega && grown(least) > exponent) least *= 0.5;
        return last_stable(least, weak_most / omega, [&](double dt) { return grown(dt) <= exponent; });
    });
}

}    // namespace

double amplification(const Case& scene, double dt) { return worst_root(scene, zone_modes(scene), dt); }

double amplification(const Case& scene, std::complex<double> z) { return worst_root(scene, {oscillation(scene, z.imag(), -z.real())}, 1); }

double oscillator_limit(const Case& scene) { return limit_of(scene, {oscillation(scene, 1, 0)}); }

double decaying_limit(const Case& scene) {
    constexpr int samples = 8;
    std::vector<Mode> modes;
    for (int i = 1; i <= samples; ++i) {
        const double decay = double(i) / samples;
        modes.push_back(oscillation(scene, 1 - decay, decay));
    }
    return limit_of(scene, modes);
}

StepLimit step_limit(const Case& scene, const std::vector<Mode>& modes) {
    const double omega = largest_frequency(modes);
    if (!(omega > 0)) return {.dt = std::numeric_limits<double>::infinity()};
    const double strict = borne_by_all(scene, modes, [&](const std::vector<Mode>& chosen) {
        return last_stable(strict_least / omega, 20 / omega, [&](double dt) { return worst_root(scene, chosen, dt) <= 1 + tolerance; });
    });
    if (strict > 0) return {.dt = strict, .frequency = omega};
    const auto exponent = [&](double dt) { return scene.until / dt * std::log(worst_root(scene, modes, dt)); };
    const double least = strict_least / omega;
    // A growth per step of theta^2 (forward Euler) gives an exponent that halves with the step, one of theta^4 an eighth of it.
    if (exponent(least) < 4 * exponent(least / 2)) return {.dt = 0, .frequency = omega, .weak = true};
    return {.dt = step_of_growth(scene, modes, omega, weak_exponent), .frequency = omega, .weak = true, .mild = step_of_growth(scene, modes, omega, 1)};
}

StepLimit step_limit(const Case& scene) { return step_limit(scene, zone_modes(scene)); }

}    // namespace sphonic
