#include "cost.hpp"

#include <algorithm>
#include <cmath>

#include "mode_system.hpp"
#include "passes.hpp"

namespace sphonic {
namespace {

/// The ends of a row take the time of so many particles, on grids of so many points, and an interface across a lattice's row of so many; in
/// single precision a vector holds twice as many.
constexpr double row_ends[] = {0, 45, 30, 30}, grid_ends = 15, across_interface = 230;

/// Plane grids of finite differences are bound by memory as soon as a core's own cache does not hold them [bytes].
constexpr double second_level = 1e6;

/// The loop about the steps takes so long to begin, and so long between samples of a run's output [ns].
constexpr double to_begin = 2000, each_sample = 100;

/// Of what could ideally be saved where particles sleep.
constexpr double saving = 0.8;
constexpr double looking = 300;    ///< for what sleeps, a step [ns]

bool in_pairs(const std::string& tier) { return tier.starts_with("frozen") && tier != "frozen_runs"; }

/// Of what a pair costs, what every call for a rate pays, however few equations it evaluates.
double geometry_share(const std::string& tier) { return tier.starts_with("moving") ? 0.4 : in_pairs(tier) ? 0.1 : 0; }

/// The most neighbours of a lattice whose rows slide: those less than four spacings away.
double most_sliding(int dimension) { return dimension == 2 ? 44 : 250; }

}    // namespace

std::string cost_tier(const Case& scene, const std::string& tier, double neighbours) {
    const int d = scene.box.dimension;
    const auto fitted = [](const Variable& v) { return std::ranges::any_of(v.terms, [](const Term& term) { return !term.fitted.empty(); }); };
    const bool on_sites = scene.arrangement->regular() && scene.jitter == 0 && !scene.media->several() && !is_viscous(scene);    // whose rows share their weights
    if (tier == "frozen") return scene.equations.dissipate() ? "frozen_dissipation" : on_sites ? "frozen_runs" : std::ranges::any_of(scene.equations.variables, fitted) ? "frozen_fitted" : tier;
    if (tier == "moving") return scene.equations.density >= 0 ? "moving_densities" : tier;
    if (!tier.starts_with("lattice")) return tier;
    const std::string rows = scene.precision == Precision::single ? "lattice_single" : "lattice";
    return d > 1 && neighbours > most_sliding(d) ? rows + "_wide" : rows;
}

bool on_rows(const std::string& tier) { return tier.starts_with("lattice") || tier == "frozen_runs" || tier == "fdtd"; }

double footprint(const Work& work) {
    const double fields = (work.tier.starts_with("lattice_single") ? 4.0 : 8.0) * (1 + work.dimension);
    return work.particles * (fields + (in_pairs(work.tier) ? work.neighbours * (4 + 8.0 * work.dimension) : 0));
}

double worth(const Work& work) {
    const double width = work.tier.starts_with("lattice_single") ? 1.5 : 1, geometry = geometry_share(work.tier);
    const double more = work.tier == "fdtd" ? grid_ends : width * row_ends[work.dimension] + across_interface * work.interfaces, ends = on_rows(work.tier) ? 1 + more / work.row : 1;
    return ends * work.particles * ((1 - geometry) * work.evaluations + geometry * work.calls);
}

double step_cost(const CostModel& costs, const Work& work) {
    const UnitCost* unit = costs.find(work.tier, work.dimension);
    if (!unit) return 0;
    const double cached = work.tier == "fdtd" && work.dimension == 2 ? second_level : costs.cache / 4, outside = std::clamp(std::log(footprint(work) / cached) / std::log(costs.cache / cached), 0.0, 1.0);
    double each = unit->fixed + work.neighbours * (unit->per_neighbour + (work.viscous ? unit->viscous : 0));
    each += outside * unit->from_memory * (in_pairs(work.tier) ? work.neighbours : 1);
    return each * worth(work) + unit->call * work.calls;
}

double predicted_seconds(const CostModel& costs, const Case& scene, const Summary& prepared, bool viscous) {
    Work work{.tier = cost_tier(scene, prepared.tier, prepared.neighbours_mean), .dimension = scene.box.dimension, .particles = double(prepared.particles), .viscous = viscous};
    const double length = scene.box.upper[0] - scene.box.lower[0];
    work.interfaces = double(scene.media->list().size()) - 1;
    if (on_rows(work.tier)) work.row = std::max(1.0, std::round(length / scene.box.dx) + (scene.box.periodic[0] ? 0 : 1));
    if (!prepared.tier.starts_with("kspace")) work.neighbours = prepared.neighbours_mean;
    if (scene.method->meshfree()) {
        const double k[3] = {1, 0, 0};
        const Symbol A = symbol(scene, k);
        ModeSystem mode(scene, A);
        mode.one_step_map(*scene.integrator, prepared.dt);
        work.evaluations = mode.evaluations(), work.calls = mode.rate_calls();
    }
    const double every = scene.output.every, samples = every > 0 ? std::min(double(prepared.steps), scene.until / every) : 0;
    const double nominal = work.particles * double(prepared.steps), ideal = prepared.ideal_particle_steps;
    const double asleep = ideal >= 0 ? saving * std::max(0.0, 1 - ideal / nominal) : 0;
    const double step = transform_factor(scene, work.tier) * step_cost(costs, work) + passes(costs, scene, prepared) * work.particles;
    const double looks = ideal >= 0 ? looking * double(prepared.steps) : 0;
    return 1e-9 * (to_begin + each_sample * samples + looks + step * double(prepared.steps) * (1 - asleep));
}

}    // namespace sphonic
