#include <sphonic/simulation.hpp>

#include <algorithm>
#include <cmath>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/version.hpp>

#include "linear_validity.hpp"
#include "machine.hpp"
#include "parallel.hpp"
#include "scene.hpp"
#include "sentinel.hpp"

namespace sphonic {
namespace {

/// The reference at the points of a snapshot; empty without one.
std::vector<double> exact_pressure(const Case& scene, double t, const abi::Points& points) {
    if (!scene.reference) return {};
    std::vector<double> p(std::size_t(points.n));
    scene.reference->reference->evaluate(t, points, {.p = p.data()});
    return p;
}

}    // namespace

Simulation::Simulation(const Case& scene) : scene_(scene) {
    const double begin = cpu_seconds();
    try {
        solver_ = scene.method->discretise(SceneView(scene).scene);
    } catch (const std::invalid_argument& e) {
        throw Error(Fault::input, scene.file + ": /method", "method " + scene.method_name + ": " + e.what());
    }
    summary_.title = scene.title;
    summary_.method = scene.method_name;
    summary_.integrator = scene.method->meshfree() ? scene.integrator_name : "its own integrator";
    summary_.warnings = scene.warnings;
    fix_step();
    try {
        solver_->start(summary_.dt);
        summary_.ideal_particle_steps = solver_->activity().ideal_steps;
    } catch (const std::invalid_argument& e) {
        throw Error(Fault::input, scene.file + ": /sources", e.what());
    }
    summary_.tier = solver_->tier();
    summary_.threads = scene.method->meshfree() ? threads_for(scene) : 1;
    summary_.neighbours_mean = solver_->neighbours_mean();
    summary_.memory_bytes = solver_->memory_bytes();
    summary_.setup_s = cpu_seconds() - begin;
    find_probes();
    sentinel_ = std::make_unique<Sentinel>(scene, *solver_, summary_.dt);
    summary_.energy_initial = summary_.energy_final = solver_->energy();
    const auto loud = beyond_linear(scene, solver_->snapshot());
    if (loud) summary_.warnings.push_back(*loud);
    beyond_linear_at_start_ = loud.has_value();
}

Simulation::~Simulation() = default;

void Simulation::find_probes() {
    const abi::Snapshot shot = solver_->snapshot();
    const int d = scene_.box.dimension;
    summary_.particles = shot.points.n;
    double x[3] = {0, 0, 0};
    in_region_.assign(std::size_t(shot.points.n), 1);
    for (int i = 0; scene_.reference && scene_.reference->region && i < shot.points.n; ++i) {
        for (int a = 0; a < d; ++a) x[a] = shot.points.x[a][i];
        in_region_[std::size_t(i)] = scene_.reference->region->contains(x);
    }
    if (std::count(in_region_.begin(), in_region_.end(), 1) == 0)
        throw Error(Fault::input, scene_.file + ": /reference/region", "no particle lies in \"" + scene_.reference->region->text() + "\"",
                    "Choose a region inside the box");
    const std::vector<double> along = places(shot.points);
    for (const auto& probe : scene_.output.probes) {
        long nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < shot.points.n; ++i) {
            double r2 = 0;
            for (int a = 0; a < d; ++a) r2 += std::pow((a ? shot.points.x[a][i] : along[std::size_t(i)]) - probe[std::size_t(a)], 2);
            if (r2 < least) least = r2, nearest = i;
        }
        probe_particles_.push_back(nearest);
        probes_.asked.push_back(probe);
        probes_.read_at.emplace_back();
        for (int a = 0; a < d; ++a) probes_.read_at.back().push_back(a ? shot.points.x[a][nearest] : along[std::size_t(nearest)]);
    }
    probes_.p.resize(probe_particles_.size());
    probes_.exact.resize(probe_particles_.size());
}

/// x of the points of a snapshot.
std::vector<double> Simulation::places(const abi::Points& points) const {
    std::vector<double> x(points.x[0], points.x[0] + points.n);
    if (scene_.stretch)
        for (double& s : x) s = scene_.place(s);
    return x;
}

void Simulation::sample() {
    if (probe_particles_.empty()) return;
    probes_.t.push_back(solver_->time());
    for (std::size_t k = 0; k < probe_particles_.size(); ++k) probes_.p[k].push_back(solver_->pressure(probe_particles_[k]));
    if (!scene_.reference) return;
    const abi::Snapshot shot = solver_->snapshot();
    for (std::size_t k = 0; k < probe_particles_.size(); ++k) {
        const long i = probe_particles_[k];
        abi::Points point{.dimension = scene_.box.dimension, .n = 1};
        for (int a = 0; a < scene_.box.dimension; ++a) point.x[a] = shot.points.x[a] + i;
        const double x = scene_.place(*point.x[0]);
        point.x[0] = &x;
        for (const double p : exact_pressure(scene_, solver_->time(), point)) probes_.exact[k].push_back(p);
    }
}

/// Steps, and lets the sentinel look between them; the number of steps taken.
long Simulation::steps(long count) {
    for (long s = 1; s <= count; ++s) {
        solver_->step();
        if (sentinel_->due()) look();
        if (summary_.diverged) return s;
    }
    return count;
}

void Simulation::look(bool end) {
    const auto complaint = sentinel_->look(end);
    if (!complaint) return;
    summary_.diverged = true;
    summary_.diverged_how = *complaint + "; " + likely_cause();
}

void Simulation::advance_to(long target, const std::function<void(const Progress&)>& progress) {
    constexpr double slice_s = 0.1;
    long done = steps_done(), slice = 1;
    while (done < target && !summary_.diverged) {
        const double cpu = cpu_seconds(), wall = wall_seconds();
        const long taken = steps(std::min(slice, target - done));
        const double spent = wall_seconds() - wall;
        summary_.cpu_s += std::max(0.0, cpu_seconds() - cpu - cpu_clock_cost());
        summary_.wall_s += spent;
        done += taken;
        sentinel_->pace(summary_.wall_s / double(done));
        if (spent < slice_s) slice *= 2;
        if (spent > 2 * slice_s) slice = std::max(1L, slice / 2);
        if (progress) progress({done, summary_.steps, summary_.wall_s});
    }
}

long Simulation::steps_done() const { return std::lround(solver_->time() / summary_.dt); }

/// The step after which the probes are read next; the last one in any case.
long Simulation::next_sample(long done) const {
    if (probe_particles_.empty()) return summary_.steps;
    const double every = scene_.output.every / summary_.dt;
    constexpr double rounding = 1e-9;
    if (every <= 1) return done + 1;
    return std::clamp(long(std::ceil((std::floor(double(done) / every + rounding) + 1) * every - rounding)), done + 1, summary_.steps);
}

void Simulation::run_to(long step, const std::function<void(const Progress&)>& progress) {
    const long last = std::min(step, summary_.steps);
    if (probes_.t.empty()) sample();
    for (long done = steps_done(); done < last && !summary_.diverged;) {
        const long due = next_sample(done);
        done = std::min(due, last);
        advance_to(done, progress);
        if (done == due) sample();
    }
}

void Simulation::run(const std::function<void(const Progress&)>& progress) {
    run_to(summary_.steps, progress);
    if (!summary_.diverged) look(true);
    summary_.t = solver_->time();
    summary_.last_good_t = sentinel_->last_good().t;
    const abi::Activity activity = solver_->activity();
    summary_.asleep_error = activity.error_bound;
    summary_.all_because = activity.all_because;
    summary_.particle_steps = activity.particle_steps >= 0 ? activity.particle_steps : double(summary_.particles) * std::round(summary_.t / summary_.dt);
    summary_.memory_bytes = solver_->memory_bytes();
    summary_.energy_final = scene_.output.fields ? solver_->energy() : std::numeric_limits<double>::quiet_NaN();
    if (scene_.reference && !summary_.diverged) summary_.errors = measure();
    if (summary_.diverged || beyond_linear_at_start_) return;
    if (const auto loud = beyond_linear(scene_, solver_->snapshot())) summary_.warnings.push_back(*loud);
}

Profile Simulation::profile() {
    if (!measured_.p.empty() && measured_.t == solver_->time()) return measured_;
    const abi::Snapshot shot = solver_->snapshot();
    Profile out{.t = solver_->time()};
    out.x[0] = places(shot.points);
    for (int a = 1; a < scene_.box.dimension; ++a) out.x[a].assign(shot.points.x[a], shot.points.x[a] + shot.points.n);
    out.p.assign(shot.p, shot.p + shot.points.n);
    complete(out);
    const bool probes_only = !scene_.output.fields && !scene_.reference;
    for (std::size_t i = 0; i < out.p.size() && !scene_.output.fields; ++i)
        if (probes_only || !in_region_[i]) out.p[i] = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < probe_particles_.size(); ++k) out.p[std::size_t(probe_particles_[k])] = shot.p[probe_particles_[k]];
    return out;
}

Profile Simulation::last_good() {
    Profile out = sentinel_->last_good();
    for (double& x : out.x[0]) x = scene_.place(x);
    complete(out);
    return out;
}

void Simulation::complete(Profile& profile) const {
    abi::Points points{.dimension = scene_.box.dimension, .n = int(profile.p.size())};
    for (int a = 0; a < scene_.box.dimension; ++a) points.x[a] = profile.x[a].data();
    profile.exact = exact_pressure(scene_, profile.t, points);
    profile.in_region = in_region_;
    if (scene_.stretch)
        for (const double x : profile.x[0]) profile.share.push_back(scene_.stretch->factor(scene_.stretch->site(x)));
}

Errors Simulation::measure() {
    measured_ = profile();
    const Profile& now = measured_;
    Errors e;
    double squares = 0, exact_squares = 0, loudest = 0, all = 0;
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        if (!now.in_region[i]) continue;
        const double difference = now.p[i] - now.exact[i], share = now.share_of(i);
        squares += share * difference * difference;
        exact_squares += share * now.exact[i] * now.exact[i];
        all += share;
        loudest = std::max(loudest, std::abs(now.exact[i]));
        e.max = std::max(e.max, std::abs(difference));
        ++e.n;
    }
    e.scale = scene_.reference->scale.value_or(loudest);
    e.eps = std::sqrt(squares) / (double(e.n) * e.scale);
    e.rms = std::sqrt(squares / all) / e.scale;
    e.l2 = std::sqrt(squares / exact_squares);
    return e;
}

}    // namespace sphonic
