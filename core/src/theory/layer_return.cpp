#include <sphonic/prediction.hpp>

#include <cmath>
#include <complex>
#include <limits>

namespace sphonic {
namespace {

using Complex = std::complex<double>;

/// p and the velocity along the normal, in units of p/(rho0 c0), at a distance from the wall.
struct State {
    Complex p = 1, u = 0;

    State operator+(const State& o) const { return {p + o.p, u + o.u}; }
    State operator*(double a) const { return {a * p, a * u}; }
};

/// How deep into the box a layer damps [m].
double thickness_of(const abi::Boundary& layer, const abi::Medium& medium, double length) {
    constexpr int samples = 4000;
    for (int i = samples; i > 0; --i)
        if (layer.damping(length * i / samples, medium) > 0) return length * std::min(i + 1, samples) / samples;
    return 0;
}

}    // namespace

double layer_return(const abi::Boundary& layer, const abi::Medium& medium, double thickness, double omega, double angle) {
    constexpr int steps = 2000;
    const double ky = omega / medium.c0 * std::sin(angle), ds = thickness / steps;
    const auto slope = [&](double s, const State& at) -> State {    // by s, away from the wall
        const Complex rate = Complex(layer.damping(s, medium), omega) / medium.c0;
        return {rate * at.u, (rate + ky * ky / rate) * at.p};
    };
    State at;
    for (int i = 0; i < steps; ++i) {    // Runge and Kutta's fourth order
        const double s = i * ds;
        const State a = slope(s, at), b = slope(s + ds / 2, at + a * (ds / 2)), c = slope(s + ds / 2, at + b * (ds / 2)), d = slope(s + ds, at + c * ds);
        at = at + (a + b * 2 + c * 2 + d) * (ds / 6);
        const double size = std::abs(at.p) + std::abs(at.u);
        at = at * (1 / size);
    }
    const double along = std::cos(angle);
    return std::abs((at.p * along - at.u) / (at.p * along + at.u));
}

std::vector<LayerReturn> layer_returns(const Case& scene) {
    std::vector<LayerReturn> all;
    double tone = std::numeric_limits<double>::infinity();
    for (const SourceUse& use : scene.sources) {
        if (use.source->tone() > 0) tone = std::min(tone, use.source->tone());
        if (const abi::PlaneWave* wave = use.source->wave()) tone = std::min(tone, wave->omega);
    }
    const double pi = std::acos(-1.0);
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true}) {
            const abi::Boundary* layer = scene.face(a, upper);
            const double thickness = layer ? thickness_of(*layer, scene.medium, scene.box.upper[a] - scene.box.lower[a]) : 0;
            if (thickness == 0) continue;
            LayerReturn one{.face = std::string(1, "xyz"[a]) + (upper ? "_max" : "_min"), .omega = tone};
            if (!std::isfinite(tone)) one.omega = 2 * pi * scene.medium.c0 / thickness;
            const auto decibels = [&](double degrees) {
                return 20 * std::log10(layer_return(*layer, scene.medium, thickness, one.omega, degrees * pi / 180));
            };
            one.normal = decibels(0);
            one.oblique = decibels(oblique_angle);
            all.push_back(one);
        }
    return all;
}

}    // namespace sphonic
