#include "search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "machine.hpp"

namespace sphonic {
namespace {

constexpr double most_particles = 4e6;
constexpr double allowed = 0.97;          ///< of the target: predictions are good to a few percent
constexpr double worth_knowing = 5;      ///< times the best's cost, by theory
constexpr double worth_running = 1.5;     ///< the same, where each takes a run
constexpr double shortest_time = 2e-5;    ///< no run costs less than that by much [s]

constexpr int most_refusals = 4;          ///< in a row, before a choice is given up

/// A choice on its way from coarse to fine.
struct Walk {
    Choice choice;
    double last_dx = 0, last_cpu_s = 0, skip_above = std::numeric_limits<double>::infinity();
    double in_any_order_to = 0;    ///< CPU time below which no spacing is passed over: between media places count for more than orders [s]
    int refused = 0;    ///< times in a row
    std::optional<Judgement> last;    ///< settled

    bool of_second_order() const { return choice.support == 0 && choice.family != "fdtd 4" && choice.family != "kspace"; }

    /// From the last spacing's: particles and steps.
    double cost_at(double dx, int dimension) const { return last_dx > 0 ? last_cpu_s * std::pow(last_dx / dx, dimension + 1) : 0; }
    void note(double dx, const Judgement& judgement, double target) {
        constexpr double settled = 0.5;    // an error below has come to its order, two unless weights are fitted, less where something else remains
        double order = 2;
        if (last && judgement.ran) order = std::clamp(std::log(last->l2 / judgement.l2) / std::log(last_dx / dx), 0.8, 2.0);
        last_dx = dx, last_cpu_s = judgement.cpu_s;
        if (!of_second_order() || judgement.l2 >= settled || judgement.cpu_s < in_any_order_to) return;
        skip_above = (judgement.ran ? 1.05 : 1.15) * dx * std::pow(target / judgement.l2, 1 / order);
        last = judgement;
    }
    /// A run of another choice erred less for less, and both do so at the same order.
    bool outdone_by(const Walk& other) const {
        constexpr double clearly = 1.15;
        return last && other.last && last->ran && other.last->ran && last->l2 > clearly * other.last->l2 && last->cpu_s > clearly * other.last->cpu_s;
    }
};

/// The same in single precision, where that applies, is cheaper and still meets the target.
std::optional<Found> in_single_precision(const OpenCase& open, const Found& found, double shortest, double target, Judge& judge) {
    if (!open.precision || found.document.value("/method/type"_json_pointer, "particles") != "particles") return {};
    Found half{.choice = found.choice, .dx = found.dx, .document = {}, .judgement = {}};
    half.choice.single = true;
    half.document = half.choice.apply(open, half.dx, shortest);
    const auto judgement = judge.judge(half.document, found.judgement.cpu_s);
    if (!judgement || judgement->l2 > allowed * target) return {};
    half.judgement = *judgement;
    return half;
}

/// Speed of the fastest medium over that of the slowest: next to no sound may reach the one with the shortest waves.
double contrast(const OpenCase& open) {
    if (!several_media(open)) return 1;
    const auto speed = [](const Json& medium) { return medium.value("c0", 1.0); };
    return speed(std::ranges::max(open.document["medium"], {}, speed)) / speed(std::ranges::min(open.document["medium"], {}, speed));
}

}    // namespace

Search search(const OpenCase& open, double target, double shortest, Judge& judge) {
    Search result;
    std::vector<Walk> left;
    for (Choice& choice : choices(open)) left.push_back({.choice = std::move(choice), .in_any_order_to = several_media(open) ? judge.budget_s() / 1000 : 0, .last = {}});
    double best = std::numeric_limits<double>::infinity();
    const double begin = cpu_seconds(), patience = judge.budget_s() / 4;
    for (const double dx : spacings(open, contrast(open) * shortest / 2.2, most_particles)) {
        std::erase_if(left, [&](Walk& walk) {
            if (!result.found.empty() && cpu_seconds() - begin > patience) return result.cut_short = true;
            const double most = (judge.trusts_theory() ? worth_knowing : worth_running) * std::max(best, shortest_time);
            if (walk.cost_at(dx, open.dimension()) > most) return true;
            if (dx > walk.skip_above) return false;
            const Json document = walk.choice.apply(open, dx, shortest);
            const auto judgement = judge.judge(document, most);
            if (!judgement) {
                if (judge.refusal == Judge::Refusal::case_refused) result.refused = judge.why;
                result.out_of_budget = result.out_of_budget || judge.refusal == Judge::Refusal::no_budget;
                return judge.refusal != Judge::Refusal::case_refused || ++walk.refused > most_refusals;
            }
            walk.refused = 0;
            const Found found{walk.choice, dx, document, *judgement};
            if (!result.nearest || judgement->l2 < result.nearest->judgement.l2) result.nearest = found;
            walk.note(dx, *judgement, target);
            if (judgement->l2 > allowed * target) return false;
            result.found.push_back(found);
            if (const auto half = in_single_precision(open, found, shortest, target, judge)) result.found.push_back(*half);
            best = std::min(best, result.found.back().judgement.cpu_s);
            return true;
        });
        std::erase_if(left, [&](const Walk& walk) { return std::ranges::any_of(left, [&](const Walk& other) { return walk.outdone_by(other); }); });
        if (left.empty()) break;
    }
    std::ranges::sort(result.found, {}, [](const Found& f) { return f.judgement.cpu_s; });
    return result;
}

}    // namespace sphonic
