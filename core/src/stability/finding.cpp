#include <cmath>

#include <sphonic/json.hpp>
#include <sphonic/simulation.hpp>
#include <sphonic/stability_report.hpp>

#include "scene.hpp"

namespace sphonic {
namespace {

constexpr double small_step = 0.1;    ///< times the largest frequency

Json step_json(const Case& scene, double dt) { return {{"dt", dt}, {"courant_dx", courant_dx(scene, dt)}}; }

StabilityTrial::Limit measure(const Case& scene, const StepLimit& predicted, const StabilityTrial::Options& options, const StabilityTrial::Report& report) {
    StabilityTrial trial(scene, options, report);
    if (predicted.dt > 0 && std::isfinite(predicted.dt))
        return predicted.weak ? trial.limit_of_growth(predicted.dt, weak_exponent) : trial.limit(predicted.dt);
    return predicted.frequency > 0 ? trial.limit(1 / predicted.frequency) : StabilityTrial::Limit{.dt = predicted.dt};
}

}    // namespace

double courant_dx(const Case& scene, double dt) { return scene.media->fastest().c0 * dt / scene.box.dx; }

StabilityFinding find_stability(const Case& scene, const StabilityTrial::Options& options, const StabilityTrial::Report& report) {
    StabilityFinding found;
    if (scene.method->meshfree()) {
        const StepTheory theory(scene);
        found.basis = theory.basis();
        found.predicted = theory.limit();
        if (found.predicted.dt == 0 && found.predicted.frequency > 0) {
            const bool own = scene.step.dt || scene.step.courant;
            const double dt = own ? asked_step(scene, 0) : small_step / found.predicted.frequency;
            found.any_step = {dt, theory.growth(dt)};
        }
        if (theory.by_box() && is_viscous(scene)) {
            found.inviscid = StepTheory(scene, {.viscosity = 0}).limit().dt;
            found.always_on = StepTheory(scene, {}).limit().dt;
        }
    } else {
        found.basis = "the method's own limit";
        found.predicted.dt = scene.method->discretise(SceneView(scene).scene)->dt_limit();
    }
    found.measured = measure(scene, found.predicted, options, report);
    return found;
}

GrowthFinding find_growth(const Case& scene, double dt, long steps, const StabilityTrial::Options& options) {
    return {dt, steps, StepTheory(scene).growth(dt), StabilityTrial(scene, options).growth(dt, steps)};
}

Json to_json(const Case& scene, const StabilityFinding& finding, const StabilityTrial::Options& options) {
    Json predicted = step_json(scene, finding.predicted.dt), measured = step_json(scene, finding.measured.dt);
    predicted["basis"] = finding.basis;
    predicted["weakly_unstable"] = finding.predicted.weak;
    if (finding.predicted.weak) predicted["mild"] = step_json(scene, finding.predicted.mild);
    if (finding.any_step) predicted["at_any_step"] = {{"dt", finding.any_step->dt}, {"growth_per_step", finding.any_step->growth}};
    if (finding.inviscid) predicted["inviscid"] = step_json(scene, *finding.inviscid);
    if (finding.always_on) predicted["always_on"] = step_json(scene, *finding.always_on);
    measured["precision"] = finding.measured.precision;
    measured["runs"] = finding.measured.runs;
    measured["steps"] = options.steps;
    return {{"title", scene.title}, {"predicted", predicted}, {"measured", measured}};
}

Json to_json(const GrowthFinding& finding) {
    return {{"dt", finding.dt}, {"steps", finding.steps}, {"predicted_per_step", finding.predicted}, {"measured_per_step", finding.measured},
            {"predicted_exponent", finding.predicted * double(finding.steps)}, {"measured_exponent", finding.measured * double(finding.steps)}};
}

}    // namespace sphonic
