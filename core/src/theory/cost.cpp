#include "cost.hpp"

#include <algorithm>
#include <cmath>

#include "mode_system.hpp"

namespace sphonic {
namespace {

/// The ends of a row take the time of so many particles.
constexpr double row_ends = 13;

/// fdtd of order 2 makes a step in one pass over the fields, unless bodies or sources of u or of rates act in its middle; then it takes
/// 1.2 to 1.8 times as long (2-D of 128^2 to 2048^2, 3-D of 64^3 and 128^3 points). Layers pass over each field again: 1.6 to 2.3 times
/// as long in 2-D, 3 to 3.7 in 3-D, where they take a good part of the box.
constexpr double apart = 1.5;
double with_layers(int dimension) { return std::max(apart, double(dimension)); }

/// Of what could ideally be saved where particles sleep.
constexpr double saving = 0.8;

/// Of what a pair costs, what every call for a rate pays, however few equations it evaluates.
double geometry_share(const std::string& tier) { return tier.starts_with("moving") ? 0.4 : tier == "frozen" ? 0.1 : 0; }

bool in_pairs(const std::string& tier) { return tier == "frozen"; }

/// How many times the cost of a step in one pass a step takes.
double passes(const Case& scene, const Summary& prepared) {
    if (prepared.tier != "fdtd" || prepared.neighbours_mean > 2 * scene.box.dimension) return 1;
    const auto damps = [&](const auto& boundary) { return boundary->damping(0, scene.medium) > 0; };
    const auto parts = [](const SourceUse& use) { return use.source->action().adds || use.source->action().sets_velocity; };
    if (std::ranges::any_of(scene.boundaries, damps)) return with_layers(scene.box.dimension);
    return std::ranges::any_of(scene.sources, parts) || !scene.obstacles.empty() ? apart : 1;
}

}    // namespace

std::string cost_tier(const std::string& tier, const Case& scene) {
    if (scene.precision == Precision::single) return "lattice_single";
    return tier == "moving" && scene.equations.density >= 0 ? "moving_densities" : tier;
}

bool on_rows(const std::string& tier) { return tier.starts_with("lattice"); }

double footprint(const Work& work) {
    const double fields = (work.tier == "lattice_single" ? 4.0 : 8.0) * (1 + work.dimension);
    return work.particles * (fields + (in_pairs(work.tier) ? work.neighbours * (4 + 8.0 * work.dimension) : 0));
}

double worth(const Work& work) {
    const double geometry = geometry_share(work.tier), ends = on_rows(work.tier) ? 1 + row_ends / work.row : 1;
    return ends * work.particles * ((1 - geometry) * work.evaluations + geometry * work.calls);
}

double step_cost(const CostModel& costs, const Work& work) {
    const UnitCost* unit = costs.find(work.tier, work.dimension);
    if (!unit) return 0;
    const double cached = costs.cache / 4, outside = std::clamp(std::log(footprint(work) / cached) / std::log(costs.cache / cached), 0.0, 1.0);
    double each = unit->fixed + work.neighbours * (unit->per_neighbour + (work.viscous ? unit->viscous : 0));
    each += outside * unit->from_memory * (in_pairs(work.tier) ? work.neighbours : 1);
    return each * worth(work) + unit->call * work.calls;
}

double predicted_seconds(const CostModel& costs, const Case& scene, const Summary& prepared, bool viscous) {
    Work work{.tier = cost_tier(prepared.tier, scene), .dimension = scene.box.dimension, .particles = double(prepared.particles), .viscous = viscous};
    const double length = scene.box.upper[0] - scene.box.lower[0];
    if (on_rows(work.tier)) work.row = std::max(1.0, std::round(length / scene.box.dx) + (scene.box.periodic[0] ? 0 : 1));
    if (!prepared.tier.starts_with("kspace")) work.neighbours = prepared.neighbours_mean;
    if (scene.method->meshfree()) {
        const double k[3] = {1, 0, 0};
        const Symbol A = symbol(scene, k);
        ModeSystem mode(scene, A);
        mode.one_step_map(*scene.integrator, prepared.dt);
        work.evaluations = mode.evaluations(), work.calls = mode.rate_calls();
    }
    const double nominal = work.particles * double(prepared.steps), ideal = prepared.ideal_particle_steps;
    const double asleep = ideal >= 0 ? saving * std::max(0.0, 1 - ideal / nominal) : 0;
    return 1e-9 * step_cost(costs, work) * double(prepared.steps) * (1 - asleep) * passes(scene, prepared);
}

}    // namespace sphonic
