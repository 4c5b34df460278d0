#include <algorithm>
#include <array>
#include <limits>

#include <sphonic/error.hpp>

#include "study_parts.hpp"

namespace sphonic {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

template <double Errors::*member>
double error(const Summary& s) {
    return s.errors ? (*s.errors).*member : unknown;
}

template <double Summary::*member>
double number(const Summary& s) {
    return s.*member;
}

constexpr auto table = std::to_array<Measure>({
    {"errors.eps", "eps, the error of Li et al.", error<&Errors::eps>, true},
    {"errors.rms", "RMS error over P", error<&Errors::rms>, true},
    {"errors.l2", "relative L2 error", error<&Errors::l2>, true},
    {"errors.max", "largest error [Pa]", error<&Errors::max>, true},
    {"cpu_s", "CPU time of stepping [s]", number<&Summary::cpu_s>},
    {"wall_s", "wall time of stepping [s]", number<&Summary::wall_s>},
    {"setup_s", "CPU time before the first step [s]", number<&Summary::setup_s>},
    {"steps", "steps", [](const Summary& s) { return double(s.steps); }},
    {"dt", "step [s]", number<&Summary::dt>},
    {"dt_limit", "stable step [s]", number<&Summary::dt_limit>},
    {"particles", "particles", [](const Summary& s) { return double(s.particles); }},
    {"ns_per_particle_step", "ns per particle-step",
     [](const Summary& s) { return 1e9 * s.wall_s / s.particle_steps; }},
    {"neighbours_mean", "neighbours", number<&Summary::neighbours_mean>},
    {"memory_bytes", "memory [bytes]", number<&Summary::memory_bytes>},
});

}    // namespace

std::span<const Measure> measures() { return table; }

const Measure& measure(const std::string& name) { return *std::ranges::find(table, name, &Measure::name); }

std::vector<std::string> measure_names() {
    std::vector<std::string> names;
    for (const Measure& m : table) names.emplace_back(m.name);
    return names;
}

std::string measure_label(const std::string& name) { return measure(name).label; }

double measured(const StudyResult& result, const std::string& name) {
    return result.status == StudyResult::Status::done ? measure(name).of(result.summary) : unknown;
}

const char* status_name(StudyResult::Status status) {
    constexpr std::array names{"done", "diverged", "refused", "not repeatable", "beyond the cut-off", "not run"};
    return names[std::size_t(status)];
}

Json to_json(const Study& study, const StudyPoint& point, const StudyResult& result) {
    Json line, labels = Json::object();
    for (std::size_t d = 0; d < study.vary.size(); ++d) labels[study.vary[d].name] = point.labels[d];
    line["labels"] = labels;
    line["family"] = point.family.empty() ? Json(nullptr) : Json(point.family);
    line["case"] = point.file.string();
    line["remove"] = point.removed;
    line["set"] = point.set;
    line["overrides"] = study.overrides;
    line["status"] = status_name(result.status);
    line["why"] = result.why;
    const double ours = measured(result, study.measure);
    line["printed"] = point.printed ? Json(*point.printed) : Json(nullptr);
    line["ratio"] = point.printed ? Json(ours / *point.printed) : Json(nullptr);
    const StudyTiming& timing = result.timing;
    line["runs"] = timing.runs;
    line["cpu_quartiles_s"] = timing.runs ? Json{timing.low, timing.high} : Json(nullptr);
    line["timing_doubt"] = timing.doubt;
    line["predicted"] = {{"l2", result.predicted_l2 ? Json(*result.predicted_l2) : Json(nullptr)}, {"cpu_s", result.predicted_cpu_s ? Json(*result.predicted_cpu_s) : Json(nullptr)}};
    const bool ran = result.status != StudyResult::Status::refused && result.status != StudyResult::Status::missing;
    const Json summary = to_json(result.summary);
    for (const auto& [key, value] : summary.items()) line[key] = ran ? value : Json(nullptr);
    return line;
}

}    // namespace sphonic
