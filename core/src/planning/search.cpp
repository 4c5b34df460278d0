#include "search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "machine.hpp"
#include "spacings.hpp"

namespace sphonic {
namespace {

constexpr double most_particles = 4e6;
constexpr double foretold = 0.97;         ///< of the target: predictions are good to a few percent
constexpr double worth_knowing = 5;      ///< times the best's cost, by theory or by runs that are short
constexpr double worth_running = 1.5;     ///< the same, of longer runs
constexpr double short_run = 0.01;        ///< [s]
constexpr double shortest_time = 2e-4;    ///< below it nobody waits, and what other families need is worth telling [s]

constexpr double fitted_order = 4;        ///< at least, of fitted weights, order 4 in space and spectral methods

constexpr int most_refusals = 4;          ///< in a row, before a choice is given up
constexpr int most_no_better = 5;         ///< the same, of runs that err no less than coarser ones: something else than the spacing is in the way

/// A choice on its way from coarse to fine.
struct Walk {
    Choice choice;
    std::size_t next = 0;    ///< of the spacings
    double last_dx = 0, last_cpu_s = 0, last_took_s = 0, skip_above = std::numeric_limits<double>::infinity();
    double in_any_order_to = 0;    ///< CPU time below which no spacing is passed over: between media places count for more than orders [s]
    int refused = 0;    ///< times in a row
    double least_l2 = std::numeric_limits<double>::infinity();
    int no_better = 0;    ///< runs since the one that erred least
    std::optional<Judgement> last;    ///< settled

    bool of_second_order() const { return choice.support == 0 && choice.family != "fdtd 4" && choice.family != "kspace"; }

    /// From the last spacing's: particles and steps.
    double cost_at(double dx, int dimension) const { return last_dx > 0 ? last_cpu_s * std::pow(last_dx / dx, dimension + 1) : 0; }
    /// Of judging it: with more particles it takes longer to set up alone.
    double to_judge_at(double dx, int dimension) const { return last_dx > 0 ? last_took_s * std::pow(last_dx / dx, dimension) : 0; }
    /// `best` is the CPU time of the cheapest that meets the target: what costs more is worth telling of, but not worth every spacing.
    void note(double dx, const Judgement& judgement, double target, double best) {
        constexpr double settled = 0.5;    // an error below has come to its order, two unless weights are fitted, less where something else remains
        double order = 2;
        if (last && judgement.ran) order = std::clamp(std::log(last->l2 / judgement.l2) / std::log(last_dx / dx), 0.8, 2.0);
        last_dx = dx, last_cpu_s = judgement.cpu_s;
        if (judgement.ran && judgement.l2 < settled && judgement.cpu_s >= in_any_order_to) no_better = judgement.l2 < 0.95 * least_l2 ? 0 : no_better + 1;
        least_l2 = std::min(least_l2, judgement.l2);
        if (judgement.cpu_s > best && judgement.l2 < settled && !of_second_order()) skip_above = dx * std::max(0.7, std::pow(target / judgement.l2, 1 / fitted_order));
        if (!of_second_order() || judgement.l2 >= settled || judgement.cpu_s < std::min(in_any_order_to, best)) return;
        skip_above = (judgement.ran ? 1.05 : 1.15) * dx * std::pow(target / judgement.l2, 1 / order);
        last = judgement;
    }
    /// A run of another choice erred less for less, and both do so at the same order.
    bool outdone_by(const Walk& other) const {
        constexpr double clearly = 1.15;
        return last && other.last && last->ran && other.last->ran && last->l2 > clearly * other.last->l2 && last->cpu_s > clearly * other.last->cpu_s;
    }
};

bool meets(const Judgement& judgement, double target) { return judgement.l2 <= (judgement.ran ? target : foretold * target); }

/// The same in single precision, where that applies, is cheaper and still meets the target.
std::optional<Found> in_single_precision(const OpenCase& open, const Found& found, double shortest, double target, Judge& judge) {
    if (!open.precision || found.document.value("/method/type"_json_pointer, "particles") != "particles") return {};
    Found half{.choice = found.choice, .dx = found.dx, .document = {}, .judgement = {}};
    half.choice.single = true;
    half.document = half.choice.apply(open, half.dx, shortest);
    const auto judgement = judge.judge(half.document, found.judgement.cpu_s);
    if (!judgement || !meets(*judgement, target)) return {};
    half.judgement = *judgement;
    return half;
}

/// Judges a choice at a spacing; true if it is to be tried at finer ones.
bool try_at(const OpenCase& open, double dx, double target, double shortest, double most_cpu_s, double best, Walk& walk, Judge& judge, Search& result) {
    if (walk.to_judge_at(dx, open.dimension()) > judge.budget_s()) {
        result.out_of_budget = true;
        return false;
    }
    const Json document = walk.choice.apply(open, dx, shortest);
    const double begin = cpu_seconds();
    const auto judgement = judge.judge(document, most_cpu_s);
    if (judgement) walk.last_took_s = cpu_seconds() - begin;
    if (!judgement) {
        if (judge.refusal == Judge::Refusal::case_refused) result.refused = judge.why;
        result.out_of_budget = result.out_of_budget || judge.refusal == Judge::Refusal::no_budget;
        return judge.refusal == Judge::Refusal::case_refused && ++walk.refused <= most_refusals;
    }
    walk.refused = 0;
    const Found found{walk.choice, dx, document, *judgement};
    if (!result.nearest || judgement->l2 < result.nearest->judgement.l2) result.nearest = found;
    walk.note(dx, *judgement, target, best);
    if (!meets(*judgement, target)) return walk.no_better < most_no_better;
    result.found.push_back(found);
    if (const auto half = in_single_precision(open, found, shortest, target, judge)) result.found.push_back(*half);
    return false;
}

/// The cheapest at the spacings between its own and the next coarser one.
void refine(const OpenCase& open, const std::vector<double>& all, double target, double shortest, Judge& judge, Search& result) {
    const Found best = result.found.front();
    const auto coarser = std::ranges::find_if(all.rbegin(), all.rend(), [&](double dx) { return dx > best.dx * (1 + 1e-9); });
    if (coarser == all.rend()) return;
    for (const double dx : spacings_between(open, *coarser, best.dx)) {
        Found found{best.choice, dx, best.choice.apply(open, dx, shortest), {}};
        const auto judgement = judge.judge(found.document, best.judgement.cpu_s);
        if (!judgement || !meets(*judgement, target)) continue;
        found.judgement = *judgement;
        result.found.insert(result.found.begin(), found);
        return;
    }
}

/// Speed of the fastest medium over that of the slowest: next to no sound may reach the one with the shortest waves.
double contrast(const OpenCase& open) {
    if (!several_media(open)) return 1;
    return speed(std::ranges::max(open.document["medium"], {}, speed)) / speed(std::ranges::min(open.document["medium"], {}, speed));
}

}    // namespace

Search search(const OpenCase& open, double target, double shortest, Judge& judge) {
    Search result;
    const std::vector<double> all = spacings(open, contrast(open) * shortest / 2.2, most_particles);
    std::vector<Walk> left;
    if (!all.empty())
        for (Choice& choice : choices(open)) left.push_back({.choice = std::move(choice), .in_any_order_to = several_media(open) ? judge.budget_s() / 1000 : 0, .last = {}});
    double best = std::numeric_limits<double>::infinity();
    const double begin = cpu_seconds(), budget = judge.budget_s(), patience = budget / 4;
    while (!left.empty()) {
        const auto next_cost = [&](const Walk& walk) { return walk.cost_at(all[walk.next], open.dimension()); };
        const auto walk = std::ranges::min_element(left, {}, next_cost);    // what costs least is tried first, and sets the bound for the rest
        const double most = (judge.trusts_theory() || best < short_run ? worth_knowing : worth_running) * std::max(best, shortest_time), dx = all[walk->next];
        if (next_cost(*walk) > most) break;
        const double taken = cpu_seconds() - begin;    // theory's share, too
        result.cut_short = !result.found.empty() && taken > patience;
        result.out_of_budget = result.out_of_budget || taken > budget;
        if (result.cut_short || taken > budget) break;
        if (!try_at(open, dx, target, shortest, most, best, *walk, judge, result)) {
            if (!result.found.empty()) best = std::min(best, result.found.back().judgement.cpu_s);
            left.erase(walk);
            continue;
        }
        do ++walk->next;
        while (walk->next < all.size() && all[walk->next] > walk->skip_above);
        if (walk->next == all.size()) left.erase(walk);
        std::erase_if(left, [&](const Walk& one) { return std::ranges::any_of(left, [&](const Walk& other) { return one.outdone_by(other); }); });
    }
    std::ranges::sort(result.found, {}, [](const Found& f) { return f.judgement.cpu_s; });
    if (!result.found.empty()) refine(open, all, target, shortest, judge, result);
    return result;
}

}    // namespace sphonic
