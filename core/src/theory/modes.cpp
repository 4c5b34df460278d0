#include "modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linear_algebra.hpp"
#include "mode_system.hpp"

namespace sphonic {
namespace {

const double pi = std::acos(-1.0);
constexpr long most_waves = 6000;    ///< of a box that are looked at one by one

Mode make_mode(const LatticeOperator& set, const double* k, Damping damping) {
    Mode mode{set.symbol(k, damping), 0, 0};
    for (const auto& value : eigenvalues(mode.symbol)) {
        mode.frequency = std::max(mode.frequency, std::abs(value));
        mode.decay = std::min(mode.decay, value.real());
    }
    return mode;
}

/// Calls visit(k) for all combinations of the wave numbers of the axes but the constant.
template <class Visit>
void for_waves(const std::vector<double> (&of_axis)[3], Visit visit) {
    double k[3];
    for (const double z : of_axis[2])
        for (const double y : of_axis[1])
            for (const double x : of_axis[0]) {
                k[0] = x, k[1] = y, k[2] = z;
                if (x != 0 || y != 0 || z != 0) visit(k);
            }
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
std::vector<Mode> zone_modes(const Case& scene, Damping damping, int medium) {
    constexpr int samples[4] = {0, 400, 32, 14};
    const LatticeOperator set(scene, medium);
    const int d = scene.box.dimension, n = samples[d];
    const double step = pi / scene.box.dx / n;
    std::vector<std::pair<Mode, std::vector<double>>> all;
    std::vector<double> of_axis[3] = {{0}, {0}, {0}};
    for (int a = 0; a < d; ++a)
        for (int m = 1; m <= n; ++m) of_axis[a].push_back(m * step);
    for_waves(of_axis, [&](const double* k) { all.emplace_back(make_mode(set, k, damping), std::vector<double>(k, k + 3)); });
    std::vector<Mode> chosen;
    const auto refine = [&](auto measure) {
        auto k = std::max_element(all.begin(), all.end(), [&](auto& a, auto& b) { return measure(a.first) < measure(b.first); })->second;
        climb(scene, k, step / 2, [&](const std::vector<double>& at) { return measure(make_mode(set, at.data(), damping)); });
        chosen.push_back(make_mode(set, k.data(), damping));
    };
    refine([](const Mode& m) { return m.frequency; });
    refine([](const Mode& m) { return -m.decay; });
    std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.first.frequency > b.first.frequency; });
    for (std::size_t i = 0; i < all.size(); i += std::max<std::size_t>(1, all.size() / 24)) chosen.push_back(std::move(all[i].first));
    return chosen;
}

/// Wave numbers that fit between the faces of an axis: whole waves, or by mirrors half waves, a quarter more between unlike ones.
std::vector<double> fitting_waves(const Case& scene, int axis) {
    const abi::Box& box = scene.box;
    std::vector<double> found;
    if (box.periodic[axis]) {
        for (long m = 0; 2 * m <= box.count[axis]; ++m) found.push_back(2 * pi * double(m) / (double(box.count[axis]) * box.dx));
        return found;
    }
    const abi::Boundary &low = *scene.face(axis, false), &high = *scene.face(axis, true);
    const double spacings = double(box.count[axis] - 1) + 0.5 * (low.half_way() + high.half_way());
    const double quarter = low.parity(abi::Part::scalar) == high.parity(abi::Part::scalar) ? 0 : 0.5;
    for (double m = quarter; m <= spacings; ++m) found.push_back(pi * m / (spacings * box.dx));
    return found;
}

}    // namespace

Mode oscillation(const Case& scene, double omega, double delta) {
    Mode mode{{}, std::hypot(omega, delta), -delta};
    for (const Variable& v : scene.equations.variables)
        if (v.evolved()) mode.symbol.n += v.components(scene.box.dimension);
    ModeSystem rows(scene, mode.symbol);
    const int p = rows.row(scene.behind(scene.equations.find("p")).variable), u = rows.row(scene.equations.find("u")), n = mode.symbol.n;
    mode.symbol.a.assign(std::size_t(n * n), 0.0);
    mode.symbol.a[std::size_t(p * n + u)] = -omega;
    mode.symbol.a[std::size_t(u * n + p)] = omega;
    mode.symbol.a[std::size_t(p * n + p)] = mode.symbol.a[std::size_t(u * n + u)] = -delta;
    return mode;
}

std::vector<Mode> zone_modes(const Case& scene) {
    Damping damping{.dissipation = scene.regular() ? 1.0 : 0.0};    // elsewhere by the assembled operator
    std::vector<Mode> most = zone_modes(scene, damping, 0);
    for (int m = 1; m < int(scene.media->list().size()); ++m)
        if (auto modes = zone_modes(scene, damping, m); modes.front().frequency > most.front().frequency) most = std::move(modes);
    if (!is_viscous(scene)) return most;
    damping.viscosity = 0;
    for (Mode& mode : zone_modes(scene, damping, 0)) most.push_back(std::move(mode));    // RK4 bears more with it
    return most;
}

bool carries_waves(const Case& scene) {
    bool closed = scene.regular() && !scene.media->several();
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true}) {
            const abi::Closure closure = scene.closure(a, upper);
            closed = closed && (closure == abi::Closure::periodic || closure == abi::Closure::mirror);
        }
    return closed;
}

std::vector<Mode> box_modes(const Case& scene, Damping damping) {
    std::vector<double> of_axis[3] = {{0}, {0}, {0}};
    std::size_t total = 1;
    for (int a = 0; a < scene.box.dimension; ++a) {
        of_axis[a] = fitting_waves(scene, a);
        total *= of_axis[a].size();
    }
    if (total > most_waves) return zone_modes(scene, damping, 0);
    const LatticeOperator set(scene);
    std::vector<Mode> modes;
    for_waves(of_axis, [&](const double* k) { modes.push_back(make_mode(set, k, damping)); });
    return modes;
}

double largest_frequency(const std::vector<Mode>& modes) {
    double largest = 0;
    for (const Mode& mode : modes) largest = std::max(largest, mode.frequency);
    return largest;
}

double worst_root(const Case& scene, const std::vector<Mode>& modes, double dt) {
    double worst = 0;
    for (const Mode& mode : modes) {
        const Symbol map = ModeSystem(scene, mode.symbol).one_step_map(*scene.integrator, dt);
        for (const double entry : map.a)
            if (!std::isfinite(entry)) return std::numeric_limits<double>::infinity();
        for (const auto& xi : eigenvalues(map)) worst = std::max(worst, std::abs(xi));
    }
    return worst;
}

}    // namespace sphonic
