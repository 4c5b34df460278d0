#include <sphonic/stability.hpp>

#include <cmath>

#include <sphonic/prediction.hpp>

#include "carried_wave.hpp"
#include "linear_algebra.hpp"
#include "mode_system.hpp"

namespace sphonic {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Pressure of the wave vector k along `direction` while a unit rate at `omega` is added to it.
std::complex<double> forced_pressure(const Case& scene, double k, const double* direction, double omega, double dt, int medium) {
    double vector[3] = {0, 0, 0};
    for (int a = 0; a < scene.box.dimension; ++a) vector[a] = k * direction[a];
    const Symbol A = symbol(scene, vector, undamped, medium);
    const int variable = scene.behind(scene.equations.find("p")).variable;
    ModeSystem mode(scene, A, ModeSystem::Forcing{variable, omega});
    const Symbol map = mode.one_step_map(*scene.integrator, dt);
    const auto z = solve_shifted(map.n, map.a.data(), std::polar(1.0, omega * dt), mode.forced().data());
    return z[std::size_t(mode.row(variable))];
}

/// In 1-D the far field is the residue of the forced response at the travelling wave's pole, i/(2 c0) in the medium; circles
/// and spheres carry k^((d-1)/2) besides, as if the set were isotropic with this direction's dispersion.
std::optional<abi::ToneResponse> along(const Case& scene, double omega, const double* direction, double dt, int medium) {
    const auto k = carried_wave_number(scene, omega, direction, dt, medium);
    if (!k) return std::nullopt;
    const double e = 1e-3 * *k;
    const auto inverse = [&](double at) { return 1.0 / forced_pressure(scene, at, direction, omega, dt, medium); };
    const double residue = std::abs(2 * e / (inverse(*k + e) - inverse(*k - e))), c0 = scene.media->list()[std::size_t(medium)].c0;
    return abi::ToneResponse{*k, 2 * c0 * residue * std::pow(*k * c0 / omega, 0.5 * (scene.box.dimension - 1))};
}

}    // namespace

std::optional<double> carried_wave_number(const Case& scene, double omega, const double* direction, double dt, int medium, double* top) {
    const auto frequency = [&](double k) { return travelling_mode(scene, k, direction, dt, undamped, medium).omega; };
    const double step = 0.02 * pi / scene.box.dx;
    double low = 0, high = step, reached = frequency(high);
    while (reached < omega) {
        low = high;
        high += step;
        const double next = frequency(high);
        if (next <= reached || high > (1 + 1e-9) * pi / scene.box.dx) {    // beyond the top of the band
            if (top) *top = reached;
            return std::nullopt;
        }
        reached = next;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (frequency(middle) < omega ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::optional<abi::ToneResponse> tone_response(const Case& scene, double omega, double dt, int medium) {
    const double diagonal2[3] = {std::sqrt(0.5), std::sqrt(0.5), 0}, diagonal3[3] = {std::sqrt(1. / 3), std::sqrt(1. / 3), std::sqrt(1. / 3)},
                 axis[3] = {1, 0, 0};
    const double* directions[] = {axis, diagonal2, diagonal3};
    const int d = scene.box.dimension;
    abi::ToneResponse mean{0, 0};
    for (int i = 0; i < d; ++i) {
        const auto one = along(scene, omega, directions[i], dt, medium);
        if (!one) return std::nullopt;
        mean.wave_number += one->wave_number / d;
        mean.gain += one->gain / d;
    }
    return mean;
}

}    // namespace sphonic
