#include <cmath>

#include <sphonic/error.hpp>
#include <sphonic/shown.hpp>
#include <sphonic/simulation.hpp>

/// The step of a run: what is asked for, against what theory says of it.
namespace sphonic {
namespace {

constexpr double exact = 1 + 1e-9;    ///< of a step at the limit itself
constexpr double noticed = 0.05;      ///< exponent of growth over a run

std::string step_text(const Case& scene, double dt) {
    return shown(dt) + " s (c0 dt/dx = " + shown(dt * scene.media->fastest().c0 / scene.box.dx) + ")";
}

/// Such as "the worst motion grows by 50 per second at any step: e^10 in this run, by e in 140 steps (0.02 s)".
std::string growth_text(const SetGrowth& set, const Summary& run, double until) {
    const double time = 1 / set.rate;
    return "the worst motion grows by " + shown(set.rate, 3) + " per second at any step: e^" + shown(set.rate * until, 3) + " in this run, by e in " +
           shown(std::ceil(time / run.dt)) + " steps (" + shown(time, 3) + " s); by " + set.basis;
}

}    // namespace

double asked_step(const Case& scene, double dt_limit) {
    const StepChoice& choice = scene.step;
    if (choice.dt) return *choice.dt;
    return choice.courant ? *choice.courant * choice.courant_length / scene.media->fastest().c0 : choice.safety * dt_limit;
}

void Simulation::take_step(const std::string& place) {
    const double dt = asked_step(scene_, summary_.dt_limit);
    if (!std::isfinite(dt)) throw Error(Fault::input, place, "no stable limit is known for this set", "Give dt or courant");
    if (summary_.dt_limit == 0 && !scene_.step.allow_unstable)
        throw Error(Fault::input, scene_.file + ": /integrator/type", "\"" + scene_.integrator_name + "\" is unstable at every step",
                    "Choose another integrator, or set \"unstable\": \"allow\" to study the failure");
    if (dt == 0) throw Error(Fault::input, place, "no step is stable", "Give dt or courant");
    const double steps = scene_.steps_of(dt);
    if (steps > 1e15) throw Error(Fault::input, place, "the run would take " + shown(steps) + " steps", "Choose a larger step or a shorter run");
    summary_.steps = long(steps);
    summary_.dt = scene_.until / steps;
}

void Simulation::fix_step() {
    const StepChoice& choice = scene_.step;
    summary_.dt_limit = solver_->dt_limit();
    summary_.weak = solver_->weakly_unstable();
    const std::string place = scene_.file + ": /integrator/" + (choice.dt ? "dt" : choice.courant ? "courant" : "safety");
    take_step(place);
    if (summary_.dt <= summary_.dt_limit * exact) set_ = set_growth(scene_, summary_.dt);
    if (set_.dt_limit) {
        summary_.dt_limit = *set_.dt_limit;
        take_step(place);
    }
    predict_growth();
    judge_set();
    if (summary_.dt <= summary_.dt_limit * exact) return;
    const std::string problem = "the step " + step_text(scene_, summary_.dt) + " is beyond the stable limit " + step_text(scene_, summary_.dt_limit);
    if (!choice.allow_unstable)
        throw Error(Fault::input, place, problem, "Choose a smaller step, or set \"unstable\": \"allow\" to study the failure");
    summary_.warnings.push_back(problem);
}

/// By the modes of the case's lattice, which other sets are near to.
void Simulation::predict_growth() {
    if (!summary_.weak || !scene_.method->meshfree()) return;
    const StepLimit limit = step_limit(scene_);
    const double same = limit.dt > 0 ? summary_.dt_limit / limit.dt : 1;    // theta is what grows: by how much the set's differs
    summary_.dt_mild = limit.mild * same;
    summary_.growth = double(summary_.steps) * std::log(amplification(scene_, summary_.dt / same));
}

/// What grows noticeably in the run is told with the limit, by more than e warned of, and by more than what a weak integrator may, refused; not beside obstacles, whose
/// walls damp what is rough.
void Simulation::judge_set() {
    const double exponent = set_.rate * scene_.until;
    if (exponent <= noticed) return;
    summary_.growth_rate = set_.rate;
    summary_.growth = std::max(summary_.growth, exponent);
    if (exponent <= 1) return;
    const std::string problem = set_.cause + ": " + growth_text(set_, summary_, scene_.until);
    if (exponent > weak_exponent && !scene_.step.allow_unstable && scene_.obstacles.empty())
        throw Error(Fault::input, scene_.file + ": " + set_.place, problem, set_.remedy + ", or set /integrator/unstable to \"allow\" to study the failure");
    summary_.warnings.push_back(problem + ". " + set_.remedy);
}

std::string Simulation::likely_cause() const {
    if (summary_.dt > summary_.dt_limit * exact)
        return "the step is " + shown(summary_.dt / summary_.dt_limit) + " times the stable limit. Take " + step_text(scene_, summary_.dt_limit) + " or less";
    if (summary_.growth_rate > 0) return set_.cause + ", by theory by " + shown(set_.rate, 3) + " per second. " + set_.remedy;
    if (summary_.weak)
        return "the integrator grows slowly at any step, by theory by e^" + shown(summary_.growth, 3) + " in this run. Take " + step_text(scene_, summary_.dt_mild) +
               " or less, or leapfrog or rk4";
    return "theory knows nothing that grows in the linear equations at this step. Look for amplitudes beyond linear acoustics, and at the sources";
}

}    // namespace sphonic
