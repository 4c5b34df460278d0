#include <sphonic/prediction.hpp>

#include <cmath>

#include <sphonic/json.hpp>
#include <sphonic/shown.hpp>

#include "cost.hpp"
#include "linear_algebra.hpp"
#include "mode_system.hpp"

namespace sphonic {
namespace {

std::string percent(double x) { return shown(100 * x, 2) + " %"; }

/// Relative L2 error over 0 <= s <= c0 * until of exp(i k s) against the numerical wave of the same frequency.
double wave_error(const Case& scene, const abi::PlaneWave& wave, double dt) {
    constexpr int samples = 400;
    const double k = wave.omega / scene.medium.c0, length = scene.medium.c0 * scene.until;
    const TravellingMode mode = travelling_mode(scene, k, wave.direction, dt, {.viscosity = 0.5});
    const double slip = k * (1 - wave.omega / mode.omega), decay = mode.decay / scene.medium.c0;
    double sum = 0;
    for (int i = 0; i < samples; ++i) {
        const double s = length * (i + 0.5) / samples, amplitude = std::exp(-decay * s);
        sum += amplitude * amplitude - 2 * amplitude * std::cos(slip * s) + 1;
    }
    return std::sqrt(sum / samples);
}

std::vector<const abi::PlaneWave*> waves_of(const Case& scene) {
    std::vector<const abi::PlaneWave*> waves;
    for (const SourceUse& use : scene.sources)
        if (const abi::PlaneWave* wave = use.source->wave()) waves.push_back(wave);
    return waves;
}

void predict_waves(const Case& scene, const Summary& prepared, Prediction& out) {
    const auto waves = waves_of(scene);
    if (waves.empty()) return;
    double error = 0, power = 0;
    for (const abi::PlaneWave* wave : waves) {
        const double e = wave_error(scene, *wave, prepared.dt), a2 = wave->amplitude * wave->amplitude;
        error += a2 * e * e;
        power += a2;
        const double per_wavelength = 2 * std::acos(-1.0) * scene.medium.c0 / (wave->omega * scene.box.dx);
        if (per_wavelength < 6)
            out.warnings.push_back("the highest source frequency has " + shown(per_wavelength, 2) +
                                   " points per wavelength: waves this short travel wrongly or not at all");
    }
    out.l2 = std::sqrt(error / power);
    out.basis = "l2: phase and decay of the sources' waves over c0 until, viscosity at half strength, fronts without their kinks; ";
}

}    // namespace

TravellingMode travelling_mode(const Case& scene, double k, const double* direction, double dt, Damping damping, int medium) {
    double vector[3] = {0, 0, 0};
    for (int a = 0; a < scene.box.dimension; ++a) vector[a] = k * direction[a];
    const Symbol A = symbol(scene, vector, damping, medium);
    const Symbol map = ModeSystem(scene, A).one_step_map(*scene.integrator, dt);
    const std::complex<double> exact = std::polar(1.0, k * scene.media->list()[std::size_t(medium)].c0 * dt);
    std::complex<double> best = 0;
    for (const auto& root : eigenvalues(map.n, map.a.data()))
        if (std::abs(root - exact) < std::abs(best - exact)) best = root;
    return {std::arg(best) / dt, -std::log(std::abs(best)) / dt};
}

Prediction predict(const Case& scene, const Summary& prepared) {
    Prediction out;
    out.memory_bytes = prepared.memory_bytes;
    out.layers = layer_returns(scene);
    const CostModel& costs = present_costs();
    out.cpu_s = predicted_seconds(costs, scene, prepared, is_viscous(scene));
    if (!scene.arrangement->regular()) out.basis = "speed and l2: known for lattices only; ";
    if (scene.media->several()) out.basis = "speed and l2: known for one medium only; ";
    if (scene.method->meshfree() && scene.arrangement->regular() && !scene.media->several()) {
        const auto waves = waves_of(scene);
        const double x_axis[3] = {1, 0, 0};
        out.speed_error = long_wave_speed(scene, waves.empty() ? x_axis : waves[0]->direction) - 1;
        if (std::abs(*out.speed_error) > 1e-3)
            out.warnings.push_back("long waves run at the wrong speed by " + percent(*out.speed_error) +
                                   ": refining dx at fixed h/dx will not converge. Choose another h/dx" +
                                   (scene.box.dimension == 1 ? ", such as 1 with cubic_spline" : ""));
        predict_waves(scene, prepared, out);
    }
    out.basis += &costs == &reference_costs() ? "cpu_s: costs of the reference machine, `sphonic calibrate` measures this one" : "cpu_s: calibrated costs of this machine";
    return out;
}

}    // namespace sphonic
