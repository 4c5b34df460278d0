#include <sphonic/stability.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "linear_algebra.hpp"
#include "mode_system.hpp"

namespace sphonic {
namespace {

constexpr double tolerance = 1e-7;          ///< of |xi|: a double root on the unit circle splits by sqrt of round-off
constexpr double strict_least = 0.1;        ///< omega dt below which a limit counts as none
constexpr double weak_most = 1;              ///< omega dt up to which a weakly unstable integrator is trusted at all
constexpr double weak_exponent = 12;        ///< growth over the run that a weakly unstable integrator may reach

struct Mode {
    Symbol symbol;
    double frequency;    ///< largest |eigenvalue| [1/s]
    double decay;        ///< most negative real part [1/s]
};

Mode make_mode(const Case& scene, const double* k, int medium) {
    Mode mode{symbol(scene, k, {.dissipation = scene.regular() ? 1.0 : 0.0}, medium), 0, 0};    // elsewhere by the assembled operator
    for (const auto& value : eigenvalues(mode.symbol.n, mode.symbol.a.data())) {
        mode.frequency = std::max(mode.frequency, std::abs(value));
        mode.decay = std::min(mode.decay, value.real());
    }
    return mode;
}

/// Climbs from the best sample to the top of a smooth function of k, halving the step.
template <class Value>
void climb(const Case& scene, std::vector<double>& k, double step, Value value) {
    double best = value(k);
    const double least = 1e-5 * step;
    while (step > least) {
        bool better = false;
        for (int a = 0; a < scene.box.dimension; ++a)
            for (const double sign : {1.0, -1.0}) {
                std::vector<double> trial = k;
                trial[std::size_t(a)] += sign * step;
                const double v = value(trial);
                if (v > best) best = v, k = trial, better = true;
            }
        if (!better) step *= 0.5;
    }
}

/// Wave vectors of one octant (the operators are even in each k_a), then the most demanding of them refined.
std::vector<Mode> demanding_modes(const Case& scene, int medium) {
    constexpr int samples[4] = {0, 400, 32, 14};
    const int d = scene.box.dimension, n = samples[d];
    const double step = std::acos(-1.0) / scene.box.dx / n;
    std::vector<std::pair<Mode, std::vector<double>>> all;
    long total = 1;
    for (int a = 0; a < d; ++a) total *= n + 1;
    for (long i = 1; i < total; ++i) {
        std::vector<double> k(3, 0.0);
        long rest = i;
        for (int a = 0; a < d; ++a, rest /= n + 1) k[std::size_t(a)] = double(rest % (n + 1)) * step;
        all.emplace_back(make_mode(scene, k.data(), medium), k);
    }
    std::vector<Mode> chosen;
    const auto refine = [&](auto measure) {
        auto k = std::max_element(all.begin(), all.end(), [&](auto& a, auto& b) { return measure(a.first) < measure(b.first); })->second;
        climb(scene, k, step / 2, [&](const std::vector<double>& at) { return measure(make_mode(scene, at.data(), medium)); });
        chosen.push_back(make_mode(scene, k.data(), medium));
    };
    refine([](const Mode& m) { return m.frequency; });
    refine([](const Mode& m) { return -m.decay; });
    std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.first.frequency > b.first.frequency; });
    for (std::size_t i = 0; i < all.size(); i += std::max<std::size_t>(1, all.size() / 24)) chosen.push_back(std::move(all[i].first));
    return chosen;
}

/// Those of the medium with the highest frequency.
std::vector<Mode> demanding_modes(const Case& scene) {
    std::vector<Mode> most = demanding_modes(scene, 0);
    for (int m = 1; m < int(scene.media->list().size()); ++m)
        if (auto modes = demanding_modes(scene, m); modes.front().frequency > most.front().frequency) most = std::move(modes);
    return most;
}

double worst_root(const Case& scene, const std::vector<Mode>& modes, double dt) {
    double worst = 0;
    for (const Mode& mode : modes) {
        const Symbol map = ModeSystem(scene, mode.symbol).one_step_map(*scene.integrator, dt);
        for (const double entry : map.a)
            if (!std::isfinite(entry)) return std::numeric_limits<double>::infinity();
        for (const auto& xi : eigenvalues(map.n, map.a.data())) worst = std::max(worst, std::abs(xi));
    }
    return worst;
}

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

/// p and u in an oscillation that decays: p' = -omega u - delta p, u' = omega p - delta u.
Mode oscillation(const Case& scene, double omega, double delta) {
    const double any[3] = {1 / scene.box.dx, 0, 0};
    Mode mode{symbol(scene, any, undamped), 1, 0};
    ModeSystem rows(scene, mode.symbol);
    const int p = rows.row(scene.behind(scene.equations.find("p")).variable), u = rows.row(scene.equations.find("u")), n = mode.symbol.n;
    mode.symbol.a.assign(std::size_t(n * n), 0.0);
    mode.symbol.a[std::size_t(p * n + u)] = -omega;
    mode.symbol.a[std::size_t(u * n + p)] = omega;
    mode.symbol.a[std::size_t(p * n + p)] = mode.symbol.a[std::size_t(u * n + u)] = -delta;
    return mode;
}

double limit_of(const Case& scene, const std::vector<Mode>& modes) {
    return last_stable(strict_least, 20, [&](double dt) { return worst_root(scene, modes, dt) <= 1 + tolerance; });
}

}    // namespace

double amplification(const Case& scene, double dt) { return worst_root(scene, demanding_modes(scene), dt); }

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

StepLimit step_limit(const Case& scene) {
    const std::vector<Mode> modes = demanding_modes(scene);
    const double omega = modes.front().frequency;
    if (!(omega > 0)) return {std::numeric_limits<double>::infinity(), 0, false};
    const double strict = last_stable(strict_least / omega, 20 / omega,
                                      [&](double dt) { return worst_root(scene, modes, dt) <= 1 + tolerance; });
    if (strict > 0) return {strict, omega, false};
    const auto exponent = [&](double dt) { return scene.until / dt * std::log(worst_root(scene, modes, dt)); };
    double least = strict_least / omega;
    // A growth per step of theta^2 (forward Euler) gives an exponent that halves with the step, one of theta^4 an eighth of it.
    if (exponent(least) < 4 * exponent(least / 2)) return {0, omega, true};
    while (least > 1e-9 / omega && exponent(least) > weak_exponent) least *= 0.5;
    return {last_stable(least, weak_most / omega, [&](double dt) { return exponent(dt) <= weak_exponent; }), omega, true};
}

}    // namespace sphonic
