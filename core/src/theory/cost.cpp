#include "cost.hpp"

#include "mode_system.hpp"

namespace sphonic {
namespace {

/// Nanoseconds of one evaluation of all equations, per particle and per neighbour, without and with viscosity, by dimension.
/// Measured on one core of an AVX-512 EPYC at 2.6 GHz with bench_steps; other machines differ in scale, hardly in ratio.
struct Cost {
    double fixed;
    double per_neighbour[4], viscous[4];
    double geometry;    ///< share of a neighbour's cost that every call pays, however few equations it evaluates
};
Cost cost_of(const std::string& tier) {
    if (tier == "lattice") return {0.4, {0, 0.13, 0.12, 0.21}, {0, 0.2, 0.56, 0.95}, 0};
    if (tier == "frozen") return {4, {0, 0.9, 2.5, 3.1}, {0, 1.5, 3.7, 4.2}, 0.1};
    if (tier == "moving") return {10, {0, 1.8, 3.0, 3.2}, {0, 0.6, 0.7, 0.7}, 0.5};
    if (tier == "moving, volumes too") return {10, {0, 3.6, 7.0, 8.5}, {0, 1.0, 2.0, 3.0}, 0.33};
    if (tier == "kspace") return {28, {}, {}, 0};    // transforms to space and back in every step
    if (tier == "kspace_modes") return {1.5, {}, {}, 0};
    return {0.4, {0, 0, 0.15, 0.3}, {}, 0};
}

}    // namespace

double predicted_seconds(const Case& scene, const Summary& prepared, bool viscous) {
    const Cost cost = cost_of(prepared.tier == "moving" && scene.equations.density >= 0 ? "moving, volumes too" : prepared.tier);
    const int d = scene.box.dimension;
    double evaluations = 1, calls = 1;
    if (scene.method->meshfree()) {
        const double k[3] = {1, 0, 0};
        const Symbol A = symbol(scene, k);
        ModeSystem mode(scene, A);
        mode.one_step_map(*scene.integrator, prepared.dt);
        evaluations = mode.evaluations(), calls = mode.rate_calls();
    }
    const double per_pair = cost.per_neighbour[d] + (viscous ? cost.viscous[d] : 0);
    const double passes = (1 - cost.geometry) * evaluations + cost.geometry * calls;
    return 1e-9 * (cost.fixed + per_pair * prepared.neighbours_mean) * passes * double(prepared.particles) * double(prepared.steps);
}

}    // namespace sphonic
