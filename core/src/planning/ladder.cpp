#include "ladder.hpp"

#include <sphonic/error.hpp>
#include <sphonic/prediction.hpp>

namespace sphonic {
namespace {

void add_rung(std::vector<Rung>& rungs, const std::string& name, const Json& document, const std::string& file, Registry& registry) {
    try {
        const Case scene = load_case(document, file, registry);
        const Simulation simulation(scene);
        const Prediction p = predict(scene, simulation.summary());
        rungs.push_back({name, p.l2, p.cpu_s});
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
    step(flat ? "the planned spacing, and no axis too many" : "the planned spacing", [&] { now = to; });
    return rungs;
}

}    // namespace sphonic
