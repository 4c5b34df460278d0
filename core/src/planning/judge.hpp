#pragma once
#include <optional>
#include <string>

#include <sphonic/plan.hpp>
#include <sphonic/simulation.hpp>

#include "fine_run.hpp"

namespace sphonic {

struct Judgement {
    double l2 = 0, cpu_s = 0;    ///< cpu_s is predicted
    std::string basis;           ///< of l2
    bool ran = false;            ///< l2 is a run's
};

/// Says what a case would give: its error by theory where it holds, else by a run, and its predicted cost.
class Judge {
public:
    /// `shortest` is the wavelength that must still be carried [m].
    Judge(const OpenCase& open, double shortest, Registry& registry, double target, double budget_s)
        : open_(open), file_(open.file), shortest_(shortest), registry_(registry), target_(target), budget_s_(budget_s) {}

    enum class Refusal { none, case_refused, too_dear, no_budget };
    /// Nothing, and in `refusal` why, for a case that does not load, that costs more than `most_cpu_s`, or that only a run could judge
    /// for which nothing is left. A run that diverges has an infinite error.
    std::optional<Judgement> judge(const Json& document, double most_cpu_s);
    Refusal refusal = Refusal::none;
    std::string why;    ///< of a refused case

    /// Error and CPU time of a run; nothing where there is nothing to hold it against, or the budget has no room.
    std::optional<std::pair<double, double>> measured(const Json& document, double share = share_to_confirm);

    /// CPU time of stepping, the least of three runs [s]; infinite where the budget has no room.
    double timed(const Json& document);

    /// What a run errs beyond theory, of a case that theory follows but for what its faces return; nothing for others.
    std::optional<double> beyond_theory(const Json& document);
    /// From now on theory's errors have this one beside them.
    void add_returned(double l2, const std::string& basis) { returned_ = l2, returned_basis_ = basis; }

    /// From now on only runs count.
    void distrust_theory() { theory_ = false; }
    bool trusts_theory() const { return theory_; }
    double budget_s() const { return budget_s_; }

private:
    /// Of the budget, that a fine run to hold others against may take: where they would not be judged otherwise, and to confirm what theory says.
    static constexpr double share_to_judge = 1.0 / 3, share_to_confirm = 1.0 / 12;

    const OpenCase open_;
    const std::string file_;
    const double shortest_;
    Registry& registry_;
    const double target_;
    double budget_s_;
    bool theory_ = true;
    double returned_ = 0;    ///< by layers
    std::string returned_basis_;

    std::unique_ptr<FineRun> fine_;    ///< once found
    double fine_share_ = 0;            ///< of the budget, that was not enough to find it

    const FineRun* fine(double share);
    std::optional<double> error_of_run(const Case& scene, Simulation& simulation);
    std::optional<Judgement> by_run(const Json& document, const Case& scene, Simulation& simulation, double cpu_s);
    double against_finer(const Json& document, const Case& scene, Simulation& run);
};

}    // namespace sphonic
