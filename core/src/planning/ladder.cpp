#include "ladder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <sphonic/error.hpp>
#include <sphonic/prediction.hpp>

namespace sphonic {
namespace {

constexpr double most_cpu_s = 0.5;    ///< of a run that tells what theory does not

/// By theory, or else by a short run beside the exact solution.
std::optional<double> error_of(const Case& scene, Simulation& simulation, const Prediction& prediction) {
    if (prediction.l2 || !scene.reference || prediction.cpu_s > most_cpu_s) return prediction.l2;
    simulation.run();
    const Summary& s = simulation.summary();
    if (s.diverged || !s.errors || !std::isfinite(s.errors->l2)) return {};
    return s.errors->l2;
}

void add_rung(std::vector<Rung>& rungs, const std::string& name, const Json& document, const std::string& file, Registry& registry) {
    try {
        const Case scene = load_case(document, file, registry);
        Simulation simulation(scene);
        const Prediction p = predict(scene, simulation.summary());
        rungs.push_back({name, error_of(scene, simulation, p), p.cpu_s});
    } catch (const Error&) {    // changes that only work together share a rung
    }
}

/// Takes a member from another document, or away where that has none.
void copy(Json& to, const Json& from, const char* key) {
    if (from.contains(key))
        to[key] = from[key];
    else
        to.erase(key);
}

/// The finest of the media's spacings for all.
Json with_one_spacing(Json document) {
    Json& dx = document["particles"]["dx"];
    for (Json& medium : document["medium"]) {
        dx = std::min(dx.get<double>(), medium.value("dx", dx.get<double>()));
        medium.erase("dx");
    }
    return document;
}

}    // namespace

std::vector<Rung> ladder(const Json& given, const OpenCase& open, bool flat, const Found& planned, Registry& registry) {
    std::vector<Rung> rungs;
    Json now = given;
    now.erase("accuracy");
    add_rung(rungs, "as given", now, open.file, registry);
    if (rungs.empty()) return {};
    const Json& to = planned.document;
    const auto step = [&](const std::string& name, auto change) {
        const Json before = now;
        change();
        if (now != before) add_rung(rungs, name, now, open.file, registry);
    };
    step(particles_that_stay, [&] { copy(now["particles"], to["particles"], "motion"), copy(now["particles"], to["particles"], "neighbours"); });
    step("the planned step", [&] { copy(now, to, "integrator"); });
    step("no viscosity", [&] { copy(now, to, "viscosity"); });
    step("the planned equations and kernel", [&] {
        if (!to.contains("equations") && !to.contains("kernel")) return;
        for (const char* key : {"equations", "kernel", "kernels", "dissipation"}) copy(now, to, key);
    });
    step("the planned method", [&] {
        for (const char* key : {"method", "equations", "kernel", "kernels", "dissipation"}) copy(now, to, key);
    });
    step("the planned precision", [&] { copy(now, to, "precision"); });
    const std::string spacing = flat ? "the planned spacing, and no axis too many" : "the planned spacing";
    if (planned.choice.own_spacings) step(spacing + ", one for all media", [&] { now = with_one_spacing(to); });
    step(planned.choice.own_spacings ? "a spacing for each medium" : spacing, [&] { now = to; });
    return rungs;
}

}    // namespace sphonic
