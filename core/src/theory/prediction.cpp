#include <sphonic/prediction.hpp>

#include <algorithm>
#include <cmath>

#include <sphonic/json.hpp>
#include <sphonic/shown.hpp>

#include "cost.hpp"
#include "estimates.hpp"
#include "field_error.hpp"
#include "front_error.hpp"
#include "linear_algebra.hpp"
#include "mode_system.hpp"

namespace sphonic {
namespace {

std::string percent(double x) { return shown(100 * x, 2) + " %"; }

/// Does all sound come from sources that send plane waves, with no body in its way?
bool fronts_only(const Case& scene) {
    return scene.obstacles.empty() && scene.initial.empty() && std::ranges::all_of(scene.sources, [](const SourceUse& use) { return use.source->wave(); });
}

/// Sources that send a plane wave.
std::vector<const SourceUse*> waves_of(const Case& scene) {
    std::vector<const SourceUse*> waves;
    for (const SourceUse& use : scene.sources)
        if (use.source->wave()) waves.push_back(&use);
    return waves;
}

/// What keeps long waves at their wrong speed, and what to choose instead.
std::string stalled_remedy(const Case& scene) {
    for (const Variable& v : scene.equations.variables)
        for (const Term& term : v.terms)
            if (!term.fitted.empty()) return "points_per_wavelength will not converge. Give the form more points_per_wavelength or a wider support";
    return std::string("h/dx will not converge. Choose another h/dx, ") + (scene.box.dimension == 1 ? "such as 1 with cubic_spline, " : "") + "or corrected_acoustics";
}

void predict_waves(const Case& scene, const Summary& prepared, Prediction& out) {
    const auto waves = waves_of(scene);
    if (waves.empty() || !fronts_only(scene)) return;
    out.l2 = fronts_error(scene, waves, prepared.dt);
    if (!out.l2) {
        out.basis = "l2: not foreseen, the sources send too many periods; ";
        return;
    }
    out.basis = "l2: speed and decay of every frequency that the sources' fronts consist of, viscosity at half strength, without what walls return; ";
}

/// Adds what comes back from faces that theory takes for open.
void add_returned(const Case& scene, Prediction& out) {
    const std::string open = ", without what comes back";
    const std::size_t at = out.basis.find(open);
    if (at == std::string::npos) return;
    const Estimate returned = returned_by_faces(scene);
    if (returned.l2) out.l2 = std::hypot(*out.l2, *returned.l2);
    out.basis = out.basis.substr(0, at) + returned.basis + "; ";
}

}    // namespace

TravellingMode travelling_mode(const Case& scene, double k, const double* direction, double dt, Damping damping, int medium) {
    double vector[3] = {0, 0, 0};
    for (int a = 0; a < scene.box.dimension; ++a) vector[a] = k * direction[a];
    if (abi::CarriedWave wave; scene.method->carry(scene.media->list()[std::size_t(medium)], scene.box, dt, vector, wave)) return {wave.omega, 0};
    const Symbol A = symbol(scene, vector, damping, medium);
    const Symbol map = ModeSystem(scene, A).one_step_map(*scene.integrator, dt);
    const std::complex<double> exact = std::polar(1.0, k * scene.media->list()[std::size_t(medium)].c0 * dt);
    std::complex<double> best = 0;
    for (const auto& root : eigenvalues(map.n, map.a.data()))
        if (std::abs(root - exact) < std::abs(best - exact)) best = root;
    return {std::arg(best) / dt, -std::log(std::abs(best)) / dt};
}

double rounding_floor(long steps) { return std::ldexp(std::sqrt(double(steps)), -24); }

namespace {

void add_rounding(const Summary& prepared, Prediction& out) {
    out.rounding = rounding_floor(prepared.steps);
    if (out.l2 && *out.l2 < 3 * *out.rounding)
        out.warnings.push_back("single precision rounds by about " + shown(*out.rounding, 1) + ", the scheme's own error is no more than " + shown(*out.l2, 1) + ": choose precision \"double\"");
}

}    // namespace

Prediction predict(const Case& scene, const Summary& prepared, Trials trials) {
    Prediction out;
    out.memory_bytes = prepared.memory_bytes;
    out.layers = layer_returns(scene);
    const CostModel& costs = present_costs();
    out.cpu_s = predicted_seconds(costs, scene, prepared, is_viscous(scene));
    if (!scene.arrangement->regular()) out.basis = "speed: known for lattices only; ";
    if (scene.media->several()) out.basis = "speed: known for one medium only; ";
    std::string why;
    if (const auto error = field_error(scene, prepared.dt, prepared.steps, why)) {
        out.l2 = error->l2();
        out.basis = error->basis + "; ";
        if (trials == Trials::allowed) add_returned(scene, out);
    }
    if (!scene.method->meshfree() && scene.regular() && !scene.media->several()) predict_waves(scene, prepared, out);
    if (scene.method->meshfree() && scene.arrangement->regular() && !scene.media->several()) {
        const auto waves = waves_of(scene);
        const double x_axis[3] = {1, 0, 0};
        out.speed_error = long_wave_speed(scene, waves.empty() ? x_axis : waves[0]->source->wave()->direction) - 1;
        if (std::abs(*out.speed_error) > 1e-3)
            out.warnings.push_back("long waves run at the wrong speed by " + percent(*out.speed_error) +
                                   ": refining dx at fixed " + stalled_remedy(scene));
        predict_waves(scene, prepared, out);
    }
    if (!out.l2 && trials == Trials::allowed) {
        const Estimate estimate = estimated_error(scene);
        out.l2 = estimate.l2;
        out.estimated = out.l2.has_value();
        out.basis += estimate.basis + "; ";
    }
    if (scene.precision == Precision::single) add_rounding(prepared, out);
    out.basis += &costs == &reference_costs() ? "cpu_s: costs of the reference machine, `sphonic calibrate` measures this one" : "cpu_s: calibrated costs of this machine";
    return out;
}

}    // namespace sphonic
