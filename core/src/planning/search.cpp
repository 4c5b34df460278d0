#include "search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
    int refused = 0;    ///< times in a row

    /// From the last spacing's: particles and steps.
    double cost_at(double dx, int dimension) const { return last_dx > 0 ? last_cpu_s * std::pow(last_dx / dx, dimension + 1) : 0; }
    void note(double dx, const Judgement& judgement, double target) {
        last_dx = dx, last_cpu_s = judgement.cpu_s;
        constexpr double settled = 0.5;    // an error below has come to its order, two unless weights are fitted
        if (choice.support == 0 && choice.family != "fdtd 4" && choice.family != "kspace" && judgement.l2 < settled) skip_above = 1.15 * dx * std::sqrt(target / judgement.l2);
    }
};

}    // namespace

Search search(const OpenCase& open, double target, double shortest, Judge& judge) {
    Search result;
    std::vector<Walk> left;
    for (Choice& choice : choices(open)) left.push_back({std::move(choice)});
    double best = std::numeric_limits<double>::infinity();
    for (const double dx : spacings(open, shortest / 2.2, most_particles)) {
        std::erase_if(left, [&](Walk& walk) {
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
            best = std::min(best, judgement->cpu_s);
            return true;
        });
        if (left.empty()) break;
    }
    std::ranges::sort(result.found, {}, [](const Found& f) { return f.judgement.cpu_s; });
    return result;
}

}    // namespace sphonic
