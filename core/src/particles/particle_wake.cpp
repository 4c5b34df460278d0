#include <cmath>

#include <sphonic/stability.hpp>

#include "particle_system.hpp"

/// Which particles of a lattice need not be stepped.
namespace sphonic {
namespace {

constexpr double worth_looking = 600;    ///< particles a step that could be spared: looking for sound takes as long as some 350, and two thirds are spared

}    // namespace

/// A variable's value where all evolved ones are at rest.
double ParticleSystem::at_rest(int variable) const {
    const Variable& v = scene_.equations.variables[std::size_t(variable)];
    if (v.evolved()) return components_.rest(components_.first[std::size_t(variable)]);
    const double x = at_rest(v.of);
    double y = 0;
    v.state->evaluate(scene_.medium, 1, &x, &y);
    return y;
}

/// What does not stay at rest without sound; empty if all does.
std::string ParticleSystem::restless() const {
    for (const Variable& v : scene_.equations.variables)
        for (const Term& term : v.terms) {
            if (at_rest(term.operand) != 0) return scene_.equations.variables[std::size_t(term.operand)].name + " is not zero at rest, and " + v.name + " follows its derivative";
            if (!term.viscosity) continue;
            const double still = 0, r2 = scene_.box.dx * scene_.box.dx;
            double Pi = 0;
            term.viscosity->pairs({.n = 1, .u_dot_r = &still, .r2 = &r2, .h = scene_.kernels[0].h, .c = scene_.medium.c0, .rho = scene_.medium.rho0}, &Pi);
            if (Pi != 0) return "the viscosity does not vanish at rest";
        }
    return {};
}

/// 1 for each particle that is asked for: those around probes, and the reference's region. Empty if the whole set is.
std::vector<char> ParticleSystem::asked_for() const {
    if (scene_.output.fields || (scene_.reference && !scene_.reference->region)) return {};
    std::vector<char> asked(std::size_t(particles()), 0);
    double x[3] = {0, 0, 0};
    for (std::size_t i = 0; i < asked.size(); ++i) {
        for (int a = 0; a < scene_.box.dimension; ++a) x[a] = x_[a][i];
        asked[i] = scene_.reference && scene_.reference->region->contains(x);
        for (const auto& probe : scene_.output.probes) {
            bool near = true;
            for (std::size_t a = 0; a < probe.size(); ++a) near = near && std::abs(x[a] - scene_.site(int(a), probe[a])) <= scene_.box.dx;
            asked[i] = asked[i] || near;
        }
    }
    return asked;
}

/// How far sound gets in one evaluation besides the stencil [dx]: through walls that read and write layers along their normal.
long ParticleSystem::through_walls() const {
    for (int a = 0; a < scene_.box.dimension; ++a)
        for (const bool upper : {false, true})
            if (scene_.closure(a, upper) == abi::Closure::layers) return 2;
    return 0;
}

/// The largest ratio of two values of the same energy in units of the first medium.
double ParticleSystem::contrast() const {
    double least = 1, most = 1, heaviest = 1;
    for (const abi::Medium& m : media_.list()) {
        least = std::min(least, bulk_modulus(m) / bulk_modulus(scene_.medium));
        most = std::max(most, bulk_modulus(m) / bulk_modulus(scene_.medium));
        heaviest = std::max(heaviest, m.rho0 / scene_.medium.rho0);
    }
    return std::sqrt(most * std::max(1 / least, heaviest));
}

/// A step's norm is that of a product of 1 + O(z) per evaluation, z = |omega| dt, O at most 2; from then on errors grow by `growth`.
void ParticleSystem::let_sleep(const StepFacts& step) {
    all_because_ = tier_->tiles() ? restless() : "only lattices have parts that sleep";
    if (!all_because_.empty()) return;
    const auto reads = [&](long index) { return long(evaluations_per_step(scene_, index)); };
    planned_[0] = reads(0);
    for (long index = 1; index < std::min(step.count, 1000L); ++index) planned_[1] = std::max(planned_[1], reads(index));
    const long beyond = through_walls(), flow = flow_.depth();
    const double z = step.dt * step.frequency;
    Wake::Plan plan{.steps = step.count, .courant = scene_.media->fastest().c0 * step.dt / scene_.box.dx, .threads = threads_};
    plan.first_reach = planned_[0] * (layout().ghosts[0] + beyond) + flow;
    plan.reach = planned_[1] * (layout().ghosts[0] + beyond) + flow;
    plan.first_radius = double(planned_[0]) * (tier_->farthest() + double(beyond)) + double(flow);
    plan.radius = double(planned_[1]) * (tier_->farthest() + double(beyond)) + double(flow);
    plan.growth = 2 * std::pow(1 + 2 * z, double(planned_[1])) * step.growth * contrast();
    for (const SourceMembers& source : sources_) plan.sources.insert(plan.sources.end(), source.at().begin(), source.at().end());
    plan.asked = asked_for();
    std::vector<Wake::Watched> watched;
    for (const int c : part(abi::fields).components) watched.push_back({field(c), components_.rest(c), unit_of(c)});
    wake_ = std::make_unique<Wake>(scene_.box, *tier_->tiles(), layout(), std::move(plan), std::move(watched));
    if (double(particles()) * double(step.count) - wake_->ideal_steps() >= worth_looking * double(step.count)) return;
    tier_->tiles()->step_only(std::vector<char>(std::size_t(tier_->tiles()->count()), 1));
    wake_.reset();
    all_because_ = "to look for what sleeps would take longer than it could spare";
}

/// Before each rate that an integrator asks for.
void ParticleSystem::note_evaluation(const Part& part) {
    if (!wake_ || part.variables.empty()) return;
    if (++evaluations_ > planned_[steps_done_ > 0]) wake_->wake_all();
}

void ParticleSystem::watch_step() {
    evaluations_ = 0;
    ++steps_done_;
    if (wake_) wake_->look();
}

abi::Activity ParticleSystem::activity() const {
    if (!wake_) return {.all_because = all_because_.c_str()};
    return {.particle_steps = wake_->particle_steps(), .ideal_steps = wake_->ideal_steps(), .error_bound = wake_->error_bound()};
}

}    // namespace sphonic
