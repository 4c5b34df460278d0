#include <sphonic/plan.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include <sphonic/error.hpp>
#include <sphonic/prediction.hpp>
#include <sphonic/shown.hpp>

#include "field_waves.hpp"
#include "ladder.hpp"
#include "layers.hpp"
#include "search.hpp"
#include "spacings.hpp"

namespace sphonic {
namespace {

/// The wavelength that must still be carried [m], by a look at the scene on a fine lattice, which finds its strata, too.
double look_at(OpenCase& open, double target, Registry& registry) {
    std::string why = "no set-up fits";
    const double fine[3] = {4e3, 4e4, 1.5e5}, points = fine[open.dimension() - 1];
    for (const double most : {points, points / 3, 10 * points})
        for (const Choice& choice : choices(open)) {
            const std::vector<double> all = spacings(open, std::numeric_limits<double>::infinity(), most);
            if (all.empty()) continue;
            try {
                const Case scene = load_case(choice.apply(open, all.back(), 10 * all.back()), open.file, registry);
                const double slowest = std::ranges::min(scene.media->list(), {}, &abi::Medium::c0).c0;
                if (open.dimension() == 1 && scene.media->several() && !scene.stretch) open.strata = strata(scene.box, scene.media->view(), scene.box.dx);
                double longest = 0;
                for (int a = 0; a < open.dimension(); ++a) longest = std::max(longest, open.length(a));
                return std::min(longest, shortest_wave(scene, 0.01 * target * target)) * slowest / scene.medium.c0;
            } catch (const Error& e) {
                why = e.what();
            }
        }
    throw Error(Fault::input, open.file + ": /", "it cannot be planned: " + why, "Mend that first");
}

/// Of the cheapest that chooses a part otherwise.
std::string savings(const Search& search, const std::string& pointer) {
    const Json::json_pointer at(pointer);
    const Found& best = search.found.front();
    const Json null, &own = best.document.contains(at) ? best.document.at(at) : null;
    for (const Found& other : search.found) {
        const Json& value = other.document.contains(at) ? other.document.at(at) : null;
        if (value != own && other.judgement.cpu_s > 1.05 * best.judgement.cpu_s) return shown(other.judgement.cpu_s / best.judgement.cpu_s, 2) + " times the time by " + other.choice.name();
    }
    return {};
}

void explain_spacings(const OpenCase& open, const Search& search, Plan& plan) {
    const Found& best = search.found.front();
    const bool own = best.choice.own_spacings;
    const auto otherwise = std::ranges::find_if(search.found, [&](const Found& other) { return other.choice.own_spacings != own; });
    const std::string saved = otherwise == search.found.end() ? "" : shown(otherwise->judgement.cpu_s / best.judgement.cpu_s, 2) + " times the time by " + otherwise->choice.name();
    const std::string shared = several_media(open) ? "; one for all media, so the slowest, with the shortest waves, decides" : "";
    if (open.spacing)
        plan.decisions.push_back({"/particles/dx", best.document.at("particles").at("dx"), "the coarsest of these at which the target is met" + (own ? ", in the first medium" : shared), own ? "" : saved});
    for (std::size_t m = 1; own && m < best.document["medium"].size(); ++m)
        plan.decisions.push_back({"/medium/" + std::to_string(m) + "/dx", best.document["medium"][m]["dx"], "as many particles to a wave as in the first medium, and as large a step", m == 1 ? saved : ""});
}

void explain(const OpenCase& open, const Search& search, Plan& plan) {
    const Found& best = search.found.front();
    const std::string cheapest = "the cheapest of what meets the target, by " + best.judgement.basis;
    const auto decide = [&](bool is_open, const std::string& pointer, const std::string& why) {
        const Json::json_pointer at(pointer);
        if (is_open && best.document.contains(at)) plan.decisions.push_back({pointer, best.document.at(at), why, savings(search, pointer)});
    };
    decide(open.method, "/method", cheapest);
    decide(open.equations, "/equations", best.choice.support > 0 ? "weights fitted to the scene's waves and the step" : cheapest);
    decide(open.kernel, "/kernel", best.choice.support > 0 ? "fitted weights need none; it sets the smallest neighbourhood" : cheapest);
    if (open.spacing || best.choice.own_spacings) explain_spacings(open, search, plan);
    decide(open.step, "/integrator", "its step: the error in time and in space offset each other, or the largest stable one");
    if (open.precision)
        plan.decisions.push_back({"/precision", best.choice.single ? "single" : "double",
                                  best.choice.single ? "its rounding and the scheme's error together meet the target" : "single precision does not apply, costs no less, or rounds too much for the target",
                                  savings(search, "/precision")});
    if (open.viscosity) plan.decisions.push_back({"/viscosity", nullptr, "the sound needs none: it damps what it should carry", ""});
}

/// What was not searched, with what the ladder says of it.
void explain_rest(const OpenCase& open, Plan& plan) {
    std::string saved;
    for (std::size_t i = 1; i < plan.ladder.size(); ++i)
        if (plan.ladder[i].name == particles_that_stay && plan.ladder[i].cpu_s > 0) saved = shown(plan.ladder[i - 1].cpu_s / plan.ladder[i].cpu_s, 2) + " times the time";
    if (open.motion) plan.decisions.push_back({"/particles/motion", "frozen", "sound moves particles by a small part of its wavelength, and their neighbours stay", saved});
    if (open.active) plan.decisions.push_back({"/active", "auto", "what no sound has reached, or what no longer matters, is not stepped, and no result changes", ""});
}

[[noreturn]] void nothing_found(const OpenCase& open, const PlanRequest& request, const Search& search) {
    const std::string place = open.file + ": /accuracy/target";
    if (!search.nearest)
        throw Error(Fault::input, open.file + ": /", "no set-up could be judged" + (search.refused.empty() ? "" : "; the last was refused: " + search.refused),
                    search.out_of_budget ? "Allow more CPU time for trial runs (--budget)" : "Mend that first");
    throw Error(Fault::input, place, "nothing tried comes to " + shown(request.target) + "; the nearest is " + search.nearest->choice.name() + " at dx = " + shown(search.nearest->dx) +
                                         " m with " + shown(search.nearest->judgement.l2, 3) + " (" + search.nearest->judgement.basis + ")",
                search.out_of_budget ? "Choose a larger target, or allow more CPU time for trial runs (--budget)" : "Choose a larger target, or leave more open (--free)");
}

/// The cheapest that also holds when it runs. Where a run belies theory, runs alone decide from then on.
void settle(const OpenCase& open, const PlanRequest& request, double shortest, Judge& judge, Search& found, Plan& plan) {
    for (;;) {
        if (found.found.empty()) nothing_found(open, request, found);
        time_cheapest(found, judge);
        const Found& best = found.found.front();
        if (const auto run = judge.measured(best.document)) {
            if (run->first > request.target && judge.trusts_theory()) {
                plan.warnings.push_back("theory promised " + shown(best.judgement.l2, 3) + " of " + best.choice.name() + ", a run gave " + shown(run->first, 3) + ": from here on by runs alone");
                judge.distrust_theory();
                found = search(open, request.target, shortest, judge);
                continue;
            }
            plan.measured_l2 = run->first;
            plan.measured_cpu_s = run->second;
        }
        return;
    }
}

}    // namespace

Plan make_plan(const Json& document, const std::filesystem::path& file, const PlanRequest& request, Registry& registry) {
    Plan plan;
    OpenCase open = opened(document, file.string(), request.free);
    plan.decisions = drop_axes(open.document);
    const bool flat = !plan.decisions.empty();
    const std::vector<std::size_t> layers = fit_layers(open, request, plan);
    const double shortest = look_at(open, request.target, registry);
    Judge judge(open, shortest, registry, request.target, request.budget_s);
    if (open.document.contains("boundaries")) weigh_layers(open, layers, request.target, shortest, judge, plan);
    Search found = search(open, request.target, shortest, judge);
    settle(open, request, shortest, judge, found, plan);
    const Found& best = found.found.front();
    explain(open, found, plan);
    std::set<std::string> seen;
    for (const Found& one : found.found)
        if (seen.insert(one.choice.family + (one.choice.own_spacings ? "+" : "")).second) plan.families.push_back({one.choice.name() + ", dx = " + shown(one.document.at("particles").at("dx").get<double>()) + " m", one.judgement.l2, one.judgement.cpu_s});
    if (found.cut_short) plan.warnings.push_back("the search ended before all was looked at: it took longer than it can save (--budget)");
    plan.document = best.document;
    plan.l2 = best.judgement.l2;
    plan.cpu_s = best.judgement.cpu_s;
    plan.basis = best.judgement.basis;
    plan.ladder = ladder(document, open, flat, best, registry);
    explain_rest(open, plan);
    return plan;
}

PlanRequest plan_request(const Json& document, const std::filesystem::path& file) {
    PlanRequest request;
    const Json& accuracy = document.at("accuracy");
    const auto refuse = [&](const std::string& pointer, const std::string& problem) {
        throw Error(Fault::input, file.string() + ": /accuracy" + pointer, problem, "Write { \"target\": 0.01 }, the relative L2 error to stay below");
    };
    if (!accuracy.is_object()) refuse("", "it is not an object");
    for (const auto& [key, value] : accuracy.items())
        if (key != "target") refuse("/" + key, "there is no such key");
    if (!accuracy.contains("target") || !accuracy["target"].is_number()) refuse("/target", "it is no number");
    request.target = accuracy["target"];
    if (!(request.target >= 1e-6 && request.target < 1)) refuse("/target", shown(request.target) + " is not between 1e-6 and 1");
    return request;
}

}    // namespace sphonic
