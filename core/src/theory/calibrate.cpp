#include <algorithm>
#include <array>
#include <cmath>

#include <sphonic/json.hpp>

#include "cost.hpp"
#include "machine.hpp"
#include "particle_system.hpp"
#include "single_system.hpp"

namespace sphonic {
namespace {

/// Of the last level, that a core of a large machine can count on [bytes].
constexpr double most_cache = 40e6;

/// What a trial is made to tell: what its neighbours cost, what Monaghan's viscosity adds, what memory adds, or what a call costs.
enum class Asked { neighbours, viscosity, memory, call };

/// One timing: a scene, and what it tells.
struct Trial {
    std::string tier;
    int dimension;
    double h_over_dx;
    Asked asked = Asked::neighbours;
    std::vector<std::string> set{};
};

struct Timing {
    Work work;
    double ns;    ///< of a step, per particle-evaluation
};

std::vector<std::string> settings_of(const std::string& tier, double h_over_dx) {
    const std::string jitter = "/particles/jitter=0.2", form = R"("form":{"type":"band_fitted","points_per_wavelength":8,"cloud_support":)" + Json(2 * h_over_dx).dump() + "}";
    if (tier.starts_with("lattice_single")) return {"/precision=single"};
    if (tier == "frozen") return {jitter};
    if (tier == "frozen_runs") return {"/particles/neighbours=frozen"};
    if (tier == "frozen_dissipation") return {jitter, "/equations=corrected_acoustics", R"(/dissipation={"type":"fourth_order","alpha":0.2})"};
    if (tier == "frozen_fitted") return {jitter, R"(/equations={"p":[{"divergence":"u","times":"-rho0*c0^2",)" + form + R"(}],"u":[{"gradient":"p","times":"-1/rho0",)" + form + "}]}"};
    if (tier == "moving") return {"/particles/motion=lagrangian"};
    if (tier == "moving_densities") return {"/particles/motion=lagrangian", "/equations=lagrangian_acoustics"};
    return {};
}

/// Particles to a side: in the caches, more than they hold, or so few that calls cost as much as particles.
int side_of(const Trial& t, double cache) {
    constexpr double neighbours[] = {0, 12, 20, 80};
    constexpr int near[] = {0, 4096, 256, 40}, near_transforms[] = {0, 4096, 512, 64}, near_list[] = {0, 2000, 72, 12}, near_moving[] = {0, 2000, 128, 20}, few[] = {0, 64, 8, 4};
    if (t.asked == Asked::call) return few[t.dimension];
    if (t.tier.starts_with("kspace")) return near_transforms[t.dimension];
    if (t.asked != Asked::memory) return (t.tier.starts_with("frozen") && t.tier != "frozen_runs" ? near_list : t.tier.starts_with("moving") ? near_moving : near)[t.dimension];
    const Work one{.tier = t.tier, .dimension = t.dimension, .particles = 1, .neighbours = neighbours[t.dimension]};
    return int(std::pow(2 * cache / footprint(one), 1.0 / t.dimension));
}

Case scene_of(const Trial& t, int side, Registry& registry) {
    const bool whole = t.tier.starts_with("kspace") || t.tier == "frozen_fitted";
    const std::vector<int> lower(std::size_t(t.dimension), 0), upper(std::size_t(t.dimension), whole ? side : side - 1);
    Json document{{"dimension", t.dimension}, {"medium", {{"c0", 1}, {"rho0", 1}}},
                  {"particles", {{"type", "lattice"}, {"dx", 1}, {"lower", lower}, {"upper", upper}}},
                  {"kernel", {{"type", "cubic_spline"}, {"h_over_dx", t.h_over_dx}}}, {"equations", "linear_acoustics"},
                  {"integrator", {{"type", "symplectic_euler"}, {"courant", 0.1}}}, {"until", 1e9}};
    if (whole) document["boundaries"] = Json::array({{{"type", "periodic"}, {"face", "all"}}});
    if (t.asked == Asked::viscosity) document["viscosity"] = {{"type", "monaghan"}, {"alpha", 0.06}, {"beta", 0.5}};
    for (const std::string& assignment : settings_of(t.tier, t.h_over_dx)) set_at(document, assignment);
    for (const std::string& assignment : t.set) set_at(document, assignment);
    Case scene = load_case(std::move(document), "calibration", registry);
    scene.threads = 1;
    return scene;
}

/// Median CPU time of a call [ns], after one that does not count.
template <class Call>
double timed(Call call) {
    constexpr int batches = 5;
    constexpr double least = 4e-3;    // seconds of a batch
    call();
    const double begin = cpu_seconds();
    call();
    const long calls = 1 + long(least / std::max(cpu_seconds() - begin, 1e-7));
    std::array<double, batches> ns{};
    for (double& batch : ns) {
        const double start = cpu_seconds();
        for (long i = 0; i < calls; ++i) call();
        batch = 1e9 * (cpu_seconds() - start) / double(calls);
    }
    std::ranges::nth_element(ns, ns.begin() + batches / 2);
    return ns[batches / 2];
}

/// By steps so short that nothing changes.
template <class System>
Timing time_particles(const Trial& t, int side, const Case& scene) {
    System system(scene);
    constexpr double dt = 1e-9;
    system.initialise(dt);
    Work work{.tier = t.tier, .dimension = t.dimension, .particles = double(system.particles()), .neighbours = system.neighbours_mean(), .viscous = t.asked == Asked::viscosity, .calls = 2};
    if (on_rows(t.tier)) work.row = side;
    long index = 0;
    const double ns = timed([&] { scene.integrator->step(system, {++index, double(index) * dt, dt}); });
    return {work, ns / worth(work)};
}

Timing time_method(const Trial& t, int side, const Case& scene) {
    Simulation simulation(scene);
    const Summary& s = simulation.summary();
    Work work{.tier = t.tier, .dimension = t.dimension, .particles = double(s.particles)};
    if (t.tier == "fdtd") work.neighbours = s.neighbours_mean, work.row = side;
    const double ns = timed([&] { simulation.solver().step(); });
    return {work, ns / worth(work)};
}

/// Trials of one tier and dimension.
std::vector<Trial> trials_of(const std::string& tier, int d) {
    using enum Asked;
    if (tier.starts_with("kspace")) {
        std::vector<std::string> set{R"(/method={"type":"kspace"})"};
        if (tier == "kspace") set.push_back(R"(/medium=[{"c0":1,"rho0":1},{"c0":2,"rho0":3,"region":"x > 3"}])");
        return {{tier, d, 1, neighbours, set}, {tier, d, 1, call, set}};
    }
    const std::string fdtd = R"(/method={"type":"fdtd"})", fdtd4 = R"(/method={"type":"fdtd","order":4})";
    if (tier == "fdtd") return {{tier, d, 1, neighbours, {fdtd}}, {tier, d, 1, neighbours, {fdtd4}}, {tier, d, 1, memory, {fdtd}}, {tier, d, 1, call, {fdtd}}};
    if (tier.ends_with("_wide")) return {{tier, d, 2.2}, {tier, d, 2.8}};
    if (tier == "frozen_dissipation" || tier == "frozen_fitted") return {{tier, d, 1.2}, {tier, d, 1.6}};
    const double h = d == 1 ? 3.25 : 1.3;
    std::vector<Trial> trials{{tier, d, 1}, {tier, d, h}, {tier, d, 1, call}};
    if (tier != "lattice_single" && tier != "frozen_runs") trials.push_back({tier, d, h, viscosity});
    if (tier.starts_with("lattice")) trials.push_back({tier, d, d == 1 ? 2.0 : 1.7});
    if (tier.starts_with("lattice") || tier == "frozen") trials.push_back({tier, d, h, memory});
    return trials;
}

/// fixed + per_neighbour n through times of several n, the least relative deviations squared; neither below zero.
UnitCost line_through(const std::vector<Timing>& timings) {
    double aa = 0, ab = 0, bb = 0, a = 0, b = 0;
    for (const Timing& t : timings) {
        const double f = 1 / t.ns, g = t.work.neighbours / t.ns;
        aa += f * f, ab += f * g, bb += g * g, a += f, b += g;
    }
    const double det = aa * bb - ab * ab;
    UnitCost cost;
    if (bb == 0 || det < 1e-9 * aa * bb) return {.fixed = a / aa};
    cost.fixed = (a * bb - b * ab) / det, cost.per_neighbour = (b * aa - a * ab) / det;
    if (cost.fixed < 0) cost = {.fixed = 0, .per_neighbour = b / bb};
    if (cost.per_neighbour < 0) cost = {.fixed = a / aa};
    return cost;
}

UnitCost unit_cost(const std::vector<Trial>& trials, const std::vector<Timing>& timings) {
    std::vector<Timing> plain;
    for (std::size_t i = 0; i < trials.size(); ++i)
        if (trials[i].asked == Asked::neighbours) plain.push_back(timings[i]);
    UnitCost cost = line_through(plain);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const Work& work = timings[i].work;
        const double n = work.neighbours, more = std::max(0.0, timings[i].ns - cost.fixed - cost.per_neighbour * n);
        if (trials[i].asked == Asked::viscosity) cost.viscous = more / n;
        if (trials[i].asked == Asked::memory) cost.from_memory = trials[i].tier.starts_with("frozen") ? more / n : more;
        if (trials[i].asked == Asked::call) cost.call = more * worth(work) / work.calls;
    }
    return cost;
}

}    // namespace

CostModel calibrate(Registry& registry, const std::function<void(double)>& progress) {
    CostModel costs{.machine = processor(), .cache = std::min(last_cache(), most_cache), .units = {}};
    std::vector<std::vector<Trial>> all;
    for (const char* tier : {"lattice", "lattice_single", "frozen", "frozen_runs", "frozen_dissipation", "frozen_fitted", "moving", "moving_densities", "fdtd", "kspace", "kspace_modes"})
        for (const int d : {1, 2, 3}) all.push_back(trials_of(tier, d));
    for (const char* tier : {"lattice_wide", "lattice_single_wide"})
        for (const int d : {2, 3}) all.push_back(trials_of(tier, d));
    for (std::size_t k = 0; k < all.size(); ++k) {
        std::vector<Timing> timings;
        for (const Trial& t : all[k]) {
            const int side = side_of(t, costs.cache);
            const Case scene = scene_of(t, side, registry);
            timings.push_back(!scene.method->meshfree()                      ? time_method(t, side, scene)
                              : scene.precision == Precision::single ? time_particles<SingleSystem>(t, side, scene)
                                                                     : time_particles<ParticleSystem>(t, side, scene));
        }
        costs.units[all[k][0].tier + " " + std::to_string(all[k][0].dimension)] = unit_cost(all[k], timings);
        if (progress) progress(double(k + 1) / double(all.size()));
    }
    return costs;
}

}    // namespace sphonic
