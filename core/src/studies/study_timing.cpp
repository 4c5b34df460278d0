#include <algorithm>
#include <cmath>

#include <sphonic/shown.hpp>

#include "study_runs.hpp"

namespace sphonic {
namespace {

using Status = StudyResult::Status;

constexpr double busy = 0.9;            ///< CPU time over wall time of a run that had the processor to itself
constexpr double unfelt_s = 1e-3;       ///< a wait that says nothing
constexpr double most_spread = 0.1;     ///< of the quartiles over the median

/// Between the order statistics of sorted times, linearly.
double quantile(const std::vector<double>& sorted, double part) {
    const double at = part * double(sorted.size() - 1);
    const auto below = std::size_t(at), above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], at - double(below));
}

std::string percent(double x) { return shown(std::round(100 * x), 3) + " %"; }

std::string doubt_of(const std::vector<StudyRun>& runs, const StudyTiming& timing, double median) {
    if (std::ranges::any_of(runs, &StudyRun::side_by_side)) return "ran side by side with others";
    const auto waited = [](const StudyRun& run) {
        const Summary& s = run.result.summary;
        return s.cpu_s < busy * s.wall_s && s.wall_s - s.cpu_s > unfelt_s;
    };
    if (const auto count = std::ranges::count_if(runs, waited); 2 * std::size_t(count) >= runs.size())
        return "waited for the processor in " + std::to_string(count) + " of " + std::to_string(runs.size()) + " runs";
    if (runs.size() >= 3 && timing.high - timing.low > most_spread * median) return "quartiles " + percent((timing.high - timing.low) / median) + " apart";
    return "";
}

bool same(const StudyResult& a, const StudyResult& b) {
    const auto& [ea, eb] = std::pair(a.summary.errors, b.summary.errors);
    const bool errors = ea && eb ? ea->l2 == eb->l2 && ea->max == eb->max : ea.has_value() == eb.has_value();
    return a.status == b.status && a.summary.steps == b.summary.steps && errors;
}

}    // namespace

StudyResult merged(const std::vector<StudyRun>& runs) {
    if (runs.empty()) return {.why = "this point was not run"};
    const auto failed = std::ranges::find_if(runs, [](const StudyRun& run) { return run.result.status != Status::done; });
    if (failed != runs.end()) return failed->result;
    std::vector<double> times;
    for (const StudyRun& run : runs) times.push_back(run.result.summary.cpu_s);
    std::ranges::sort(times);
    const double median = times[(times.size() - 1) / 2];
    const auto middle = std::ranges::find(runs, median, [](const StudyRun& run) { return run.result.summary.cpu_s; });
    StudyResult result = middle->result;
    result.timing = {.runs = int(runs.size()), .low = quantile(times, 0.25), .high = quantile(times, 0.75), .doubt = ""};
    result.timing.doubt = doubt_of(runs, result.timing, median);
    const auto repeats = [&](const StudyRun& run) { return same(run.result, runs[0].result); };
    if (!std::ranges::all_of(runs, repeats)) result.status = Status::unrepeatable, result.why = "repetitions of this point differ in steps or errors";
    return result;
}

}    // namespace sphonic
