#include "estimates.hpp"

#include <algorithm>
#include <cmath>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/shown.hpp>

#include "cost.hpp"
#include "field_error.hpp"

namespace sphonic {
namespace {

constexpr double most_seconds = 1.0;    ///< of CPU for one run at a coarser spacing

/// Spacings between walls that must stay where they are, or between periodic images; 0 where the set may end anywhere.
double whole_length(const Case& scene, int axis) {
    double spacings = double(scene.box.count[axis]) - 1;
    for (const bool upper : {false, true}) {
        const abi::Boundary* face = scene.face(axis, upper);
        if (!face || face->closure() == abi::Closure::free || face->damping(0, scene.medium) > 0) return 0;
        spacings += face->closure() == abi::Closure::periodic || face->half_way() ? 0.5 : 0;
    }
    return spacings;
}

/// The factor next to `wanted` by which a spacing may grow with all such lengths still whole; 0: there is none.
double whole_factor(const Case& scene, double wanted) {
    const auto fits = [&](double factor) {
        for (int a = 0; a < scene.box.dimension; ++a)
            if (const double n = whole_length(scene, a) / factor; std::abs(n - std::round(n)) > 1e-6) return false;
        return true;
    };
    double longest = 0, best = 0;
    for (int a = 0; a < scene.box.dimension; ++a) longest = std::max(longest, whole_length(scene, a));
    if (longest == 0) return wanted;
    for (double n = std::ceil(longest / (1.25 * wanted)); n <= longest / (0.75 * wanted); ++n)
        if (fits(longest / n) && std::abs(longest / n - wanted) < std::abs(best - wanted)) best = longest / n;
    return best;
}

/// A case at a coarser spacing, run to its end.
struct CoarseRun {
    double factor = 0, error = 0, theory = 0;    ///< L2; `theory` 0 where there is none
    std::string refusal;             ///< why there is no run; empty: there is
};

/// Lengths that are given in metres grow with the spacing, and so does a given step.
Json coarser(const Case& scene, double factor) {
    Json document = *scene.resolved;
    const auto stretch = [&](Json& object, const char* member) {
        if (object.is_object() && object.contains(member) && object[member].is_number()) object[member] = factor * double(object[member]);
    };
    stretch(document["particles"], "dx");
    if (document["medium"].is_array())
        for (Json& medium : document["medium"]) stretch(medium, "dx");
    stretch(document["integrator"], "dt");
    stretch(document["integrator"], "courant_length");
    for (const char* kernels : {"kernel", "kernels"}) {
        if (!document.contains(kernels)) continue;
        stretch(document[kernels], "h");
        for (Json& one : document[kernels])
            if (one.is_object()) stretch(one, "h");
    }
    return document;
}

CoarseRun run_coarser(const Case& scene, double wanted) {
    const double factor = whole_factor(scene, wanted);
    CoarseRun out{.factor = factor};
    if (factor == 0) return {.refusal = "no spacing some " + shown(wanted) + " times as coarse fits the box"};
    try {
        const Case coarse = load_case(coarser(scene, factor), scene.file, *scene.registry);
        Simulation simulation(coarse);
        const Summary& s = simulation.summary();
        const double seconds = predicted_seconds(present_costs(), coarse, s, is_viscous(coarse));
        if (seconds > most_seconds) return {.refusal = "a run at " + shown(factor, 3) + " dx would take " + shown(seconds, 2) + " s"};
        std::string why;
        if (const auto theory = field_error(coarse, s.dt, s.steps, why)) out.theory = theory->l2();
        simulation.run();
        out.error = s.errors ? s.errors->l2 : 0;
        if (s.diverged || !std::isfinite(out.error) || out.error <= 0) out.refusal = "a run at " + shown(factor) + " dx gives no error to go by";
    } catch (const Error& e) {
        if (e.fault != Fault::input) throw;
        out.refusal = "it cannot be run at " + shown(factor) + " dx (" + e.what() + ")";
    }
    return out;
}

}    // namespace

Estimate estimated_error(const Case& scene) {
    if (!scene.reference) return {{}, "l2: not foreseen, theory does not know the scene and it has no exact solution to try coarser runs against"};
    const CoarseRun twice = run_coarser(scene, 2);
    if (!twice.refusal.empty()) return {{}, "l2: not foreseen, " + twice.refusal};
    const CoarseRun four = run_coarser(scene, 4);
    const bool shows = four.refusal.empty() && four.error < 0.7;
    const double order = shows ? std::clamp(std::log(four.error / twice.error) / std::log(four.factor / twice.factor), 0.0, 4.0) : 2;
    const std::string runs = "l2: an estimate from a run at " + shown(twice.factor, 3) + " dx that errs by " + shown(twice.error, 2) + ", continued by order " + shown(order, 2);
    return {twice.error * std::pow(twice.factor, -order), runs + (shows ? ", which a run at " + shown(four.factor, 3) + " dx shows" : "")};
}

Estimate returned_by_faces(const Case& scene) {
    if (!scene.reference) return {{}, ", without what comes back from open or absorbing faces: there is no exact solution to try a coarser run against"};
    const CoarseRun twice = run_coarser(scene, 2);
    if (!twice.refusal.empty()) return {{}, ", without what comes back from open or absorbing faces: " + twice.refusal};
    return {std::sqrt(std::max(0.0, twice.error * twice.error - twice.theory * twice.theory)), ", and what comes back from faces by a run at 2 dx"};
}

}    // namespace sphonic
