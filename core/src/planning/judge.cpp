#include "judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <sphonic/error.hpp>
#include <sphonic/prediction.hpp>

#include "cost.hpp"
#include "field_error.hpp"
#include "machine.hpp"

namespace sphonic {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Theory knows walls that are bodies, and sets that are no lattice, only in part.
bool theory_holds(const Case& scene) { return scene.regular() && scene.motion == Motion::frozen; }

constexpr double other_moment = 0.93;    ///< of the end; later ones tell a phase better, and it must be no whole share of a period

/// By theory, at the end and a little before, over the louder of both: at one moment a wave that is late by a whole period looks right,
/// and a standing one at its height hardly shows that it is late. Single precision adds its rounding.
std::optional<Judgement> by_theory(const Case& scene, const Summary& prepared, double target, double cpu_s) {
    std::string why;
    const double precision = target / 30;
    const auto late = field_error(scene, prepared.dt, prepared.steps, why, precision);
    if (!late) {
        const Prediction p = predict(scene, prepared);
        if (!p.l2) return {};
        return Judgement{*p.l2, cpu_s, p.basis.substr(0, p.basis.find(';'))};
    }
    Judgement judgement{late->l2(), cpu_s, late->basis};
    if (judgement.l2 > target) return judgement;
    const auto early = field_error(scene, prepared.dt, std::max(1L, std::lround(other_moment * double(prepared.steps))), why, precision);
    judgement.l2 = std::max(judgement.l2, std::sqrt(early->error / std::max(early->power, late->power)));
    return judgement;
}

using Place = std::array<long, 3>;
Place place_of(const Profile& profile, std::size_t i, const abi::Box& box, double dx) {
    Place place{0, 0, 0};
    for (int a = 0; a < box.dimension; ++a) place[std::size_t(a)] = std::lround((profile.x[a][i] - box.lower[a]) / dx);
    return place;
}

}    // namespace

std::optional<Judgement> Judge::judge(const Json& document, double most_cpu_s) {
    refusal = budget_s_ > 0 ? Refusal::case_refused : Refusal::no_budget;
    if (budget_s_ <= 0) return {};
    const double begin = cpu_seconds();
    try {
        const Case scene = load_case(document, file_, registry_);
        Simulation simulation(scene);
        const double cpu_s = predicted_seconds(present_costs(), scene, simulation.summary(), is_viscous(scene));
        refusal = Refusal::too_dear;
        if (cpu_s > most_cpu_s) return {};
        refusal = Refusal::none;
        if (theory_ && theory_holds(scene))
            if (auto judgement = by_theory(scene, simulation.summary(), target_, cpu_s)) {
                if (scene.precision == Precision::single) judgement->l2 += rounding_floor(simulation.summary().steps);
                judgement->l2 = std::hypot(judgement->l2, returned_);
                if (returned_ > 0) judgement->basis = judgement->basis.substr(0, judgement->basis.find(", without what comes back")) + returned_basis_;
                return judgement;
            }
        const auto judgement = by_run(document, scene, simulation, cpu_s);
        budget_s_ -= cpu_seconds() - begin;
        return judgement;
    } catch (const Error& e) {
        if (e.fault != Fault::input) throw;
        why = e.what();
        return {};
    }
}

std::optional<Judgement> Judge::by_run(const Json& document, const Case& scene, Simulation& simulation, double cpu_s) {
    const double needed = cpu_s * (scene.reference ? 1 : 1 + std::pow(2.0, scene.box.dimension + 1));
    if (needed > budget_s_) {
        refusal = Refusal::no_budget;
        return {};
    }
    simulation.run();
    const Summary& s = simulation.summary();
    if (s.diverged) return Judgement{infinite, cpu_s, "l2: a run that diverged", true};
    if (s.errors) return Judgement{std::isfinite(s.errors->l2) ? s.errors->l2 : infinite, cpu_s, "l2: a run beside the exact solution", true};
    return Judgement{against_finer(document, scene, simulation), cpu_s, "l2: 4/3 of the difference from a run at half the spacing", true};
}

std::optional<double> Judge::beyond_theory(const Json& document) {
    try {
        const Case scene = load_case(document, file_, registry_);
        if (!scene.reference || !theory_holds(scene)) return {};
        Simulation simulation(scene);
        std::string why;
        const auto theory = field_error(scene, simulation.summary().dt, simulation.summary().steps, why);
        const auto run = theory ? measured(document) : std::nullopt;
        if (!run || !std::isfinite(run->first)) return {};
        return std::sqrt(std::max(0.0, run->first * run->first - theory->l2() * theory->l2()));
    } catch (const Error& e) {
        if (e.fault != Fault::input) throw;
        return {};
    }
}

double Judge::against_finer(const Json& document, const Case& scene, Simulation& run) {
    Json finer = document;
    finer["particles"]["dx"] = scene.box.dx / 2;
    const Case fine_scene = load_case(std::move(finer), file_, registry_);
    Simulation fine(fine_scene);
    fine.run();
    if (fine.summary().diverged) return infinite;
    const Profile coarse = run.profile(), exact = fine.profile();
    std::map<Place, double> at;
    for (std::size_t i = 0; i < exact.p.size(); ++i) at[place_of(exact, i, scene.box, scene.box.dx / 2)] = exact.p[i];
    double error = 0, power = 0;
    for (std::size_t i = 0; i < coarse.p.size(); ++i) {
        Place place = place_of(coarse, i, scene.box, scene.box.dx);
        for (long& n : place) n *= 2;
        const auto found = at.find(place);
        if (found == at.end()) continue;
        error += std::pow(coarse.p[i] - found->second, 2);
        power += found->second * found->second;
    }
    return power > 0 ? 4.0 / 3 * std::sqrt(error / power) : infinite;    // of second order
}

double Judge::timed(const Json& document) {
    const Case scene = load_case(document, file_, registry_);
    double least = infinite;
    for (int run = 0; run < 3 && budget_s_ > 0; ++run) {
        Simulation simulation(scene);
        simulation.run();
        least = std::min(least, simulation.summary().cpu_s);
        budget_s_ -= simulation.summary().cpu_s + simulation.summary().setup_s;
    }
    return least;
}

std::optional<std::pair<double, double>> Judge::measured(const Json& document) {
    const Case scene = load_case(document, file_, registry_);
    if (!scene.reference) return {};
    Simulation simulation(scene);
    if (predicted_seconds(present_costs(), scene, simulation.summary(), is_viscous(scene)) > budget_s_) return {};
    simulation.run();
    const Summary& s = simulation.summary();
    budget_s_ -= s.cpu_s + s.setup_s;
    const bool sound = !s.diverged && s.errors && std::isfinite(s.errors->l2);
    return std::pair{sound ? s.errors->l2 : infinite, s.cpu_s};
}

}    // namespace sphonic
