#include "judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <sphonic/error.hpp>
#include <sphonic/prediction.hpp>
#include <sphonic/shown.hpp>

#include "cost.hpp"
#include "field_error.hpp"
#include "machine.hpp"

namespace sphonic {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Takes from a budget what passes while it lives. [CPU s]
class Spent {
public:
    explicit Spent(double& budget) : budget_(budget) {}
    Spent(const Spent&) = delete;
    Spent& operator=(const Spent&) = delete;
    ~Spent() { budget_ -= nothing_ ? 0 : cpu_seconds() - begin_; }
    void nothing() { nothing_ = true; }

private:
    double& budget_;
    const double begin_ = cpu_seconds();
    bool nothing_ = false;
};

/// Theory knows walls that are bodies, and sets that are no lattice, only in part.
bool theory_holds(const Case& scene) { return scene.regular() && scene.motion == Motion::frozen; }

/// By theory, at both moments.
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
    const auto early = field_error(scene, prepared.dt, other_step(prepared.steps), why, precision);
    judgement.l2 = worst_l2({early->error, early->power}, {late->error, late->power});
    return judgement;
}

/// Beside the exact solution, in its region.
Moment beside_exact(const Profile& now) {
    Moment moment;
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        if (!now.in_region[i]) continue;
        moment.error += now.share_of(i) * std::pow(now.p[i] - now.exact[i], 2);
        moment.power += now.share_of(i) * now.exact[i] * now.exact[i];
    }
    return moment;
}

/// What a run errs over how much half its spacing changes, at the order that the scene leaves: one where bodies are staircases, or media meet between sites.
double of_difference(const Case& scene) { return scene.obstacles.empty() && scene.media->list().size() == 1 ? 4.0 / 3 : 2; }

using Place = std::array<long, 3>;
Place place_of(const Case& scene, const Profile& profile, std::size_t i, double dx) {
    Place place{0, 0, 0};
    for (int a = 0; a < scene.box.dimension; ++a) place[std::size_t(a)] = std::lround((scene.site(a, profile.x[a][i]) - scene.box.lower[a]) / dx);
    return place;
}

}    // namespace

std::optional<Judgement> Judge::judge(const Json& document, double most_cpu_s) {
    refusal = budget_s_ > 0 ? Refusal::case_refused : Refusal::no_budget;
    if (budget_s_ <= 0) return {};
    Spent spent(budget_s_);
    try {
        const Case scene = load_case(document, file_, registry_);
        Simulation simulation(scene);
        const double cpu_s = predicted_seconds(present_costs(), scene, simulation.summary(), is_viscous(scene));
        refusal = Refusal::too_dear;
        if (cpu_s > most_cpu_s) return {};
        refusal = Refusal::none;
        if (theory_ && theory_holds(scene))
            if (auto judgement = by_theory(scene, simulation.summary(), target_, cpu_s)) {
                spent.nothing();
                if (scene.precision == Precision::single) judgement->l2 += rounding_floor(simulation.summary().steps);
                judgement->l2 = std::hypot(judgement->l2, returned_);
                if (returned_ > 0) judgement->basis = judgement->basis.substr(0, judgement->basis.find(", without what comes back")) + returned_basis_;
                return judgement;
            }
        return by_run(document, scene, simulation, cpu_s);
    } catch (const Error& e) {
        if (e.fault != Fault::input) throw;
        why = e.what();
        return {};
    }
}

/// To hold runs against where there is no exact solution: of scenes whose method or equations are open, for then they are linear acoustics.
const FineRun* Judge::fine(double share) {
    if (fine_ || share <= fine_share_ || !(open_.method || open_.equations)) return fine_.get();
    fine_ = FineRun::find(open_, shortest_, target_, share * budget_s_, registry_);
    fine_share_ = share;
    return fine_.get();
}

/// Runs to the end; nothing where there is neither an exact solution nor a fine run.
std::optional<double> Judge::error_of_run(const Case& scene, Simulation& simulation) {
    if (!scene.reference && !fine_) return {};
    const auto moment = [&](bool at_end) { return scene.reference ? beside_exact(simulation.profile()) : fine_->moment(simulation.profile(), at_end); };
    simulation.run_to(other_step(simulation.summary().steps));
    const Moment other = moment(false);
    simulation.run();
    const double l2 = simulation.summary().diverged ? infinite : worst_l2(other, moment(true)) + (scene.reference ? 0 : fine_->off_by());
    return std::isfinite(l2) ? l2 : infinite;
}

std::optional<Judgement> Judge::by_run(const Json& document, const Case& scene, Simulation& simulation, double cpu_s) {
    const bool held_against = scene.reference || fine(share_to_judge);
    const double needed = cpu_s * (held_against ? 1 : 1 + std::pow(2.0, scene.box.dimension + 1));
    if (needed > budget_s_) {
        refusal = Refusal::no_budget;
        return {};
    }
    if (const auto l2 = error_of_run(scene, simulation))
        return Judgement{*l2, cpu_s, "l2: a run beside " + (scene.reference ? "the exact solution" : fine_->name() + ", itself within " + shown(fine_->off_by(), 2)), true};
    const bool no_pairs = scene.jitter != 0 || !scene.arrangement->regular();    // of the same places
    if (no_pairs) {
        refusal = Refusal::case_refused;
        why = file_ + ": /reference: a set without order is judged beside an exact solution or a fine run, and there is neither";
        return {};
    }
    simulation.run();
    if (simulation.summary().diverged) return Judgement{infinite, cpu_s, "l2: a run that diverged", true};
    return Judgement{against_finer(document, scene, simulation), cpu_s, "l2: " + shown(of_difference(scene), 3) + " times the difference from a run at half the spacing", true};
}

std::optional<double> Judge::beyond_theory(const Json& document) {
    try {
        const Case scene = load_case(document, file_, registry_);
        if (!theory_holds(scene)) return {};
        Simulation simulation(scene);
        std::string why;
        const auto theory = field_error(scene, simulation.summary().dt, simulation.summary().steps, why);
        const auto run = theory ? measured(document, share_to_judge) : std::nullopt;
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
    if (scene.stretch)
        for (std::size_t m = 1; m < finer["medium"].size(); ++m) finer["medium"][m]["dx"] = scene.stretch->factors()[m] * scene.box.dx / 2;
    const Case fine_scene = load_case(std::move(finer), file_, registry_);
    Simulation fine(fine_scene);
    fine.run();
    if (fine.summary().diverged) return infinite;
    const Profile coarse = run.profile(), exact = fine.profile();
    std::map<Place, double> at;
    for (std::size_t i = 0; i < exact.p.size(); ++i) at[place_of(scene, exact, i, scene.box.dx / 2)] = exact.p[i];
    double error = 0, power = 0;
    for (std::size_t i = 0; i < coarse.p.size(); ++i) {
        Place place = place_of(scene, coarse, i, scene.box.dx);
        for (long& n : place) n *= 2;
        const auto found = at.find(place);
        if (found == at.end()) continue;
        error += coarse.share_of(i) * std::pow(coarse.p[i] - found->second, 2);
        power += coarse.share_of(i) * found->second * found->second;
    }
    return power > 0 ? of_difference(scene) * std::sqrt(error / power) : infinite;
}

double Judge::timed(const Json& document) {
    const Case scene = load_case(document, file_, registry_);
    double least = infinite;
    for (int run = 0; run < 3 && budget_s_ > 0; ++run) {
        const Spent spent(budget_s_);
        Simulation simulation(scene);
        simulation.run();
        least = std::min(least, simulation.summary().cpu_s);
    }
    return least;
}

std::optional<std::pair<double, double>> Judge::measured(const Json& document, double share) {
    const Spent spent(budget_s_);
    const Case scene = load_case(document, file_, registry_);
    if (!scene.reference && !fine(share)) return {};
    Simulation simulation(scene);
    if (predicted_seconds(present_costs(), scene, simulation.summary(), is_viscous(scene)) > budget_s_) return {};
    const double l2 = *error_of_run(scene, simulation);
    return std::pair{l2, simulation.summary().cpu_s};
}

}    // namespace sphonic
