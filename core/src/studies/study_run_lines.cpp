#include <limits>
#include <map>

#include "study_parts.hpp"
#include "study_runs.hpp"

namespace sphonic {
namespace {

using Status = StudyResult::Status;

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::optional<double> optional_real(const Json& value) { return value.is_number() ? std::optional(value.get<double>()) : std::nullopt; }

/// JSON has no NaN: null stands for it.
double real(const Json& value) { return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN(); }

Status status_of(const std::string& name) {
    for (const Status status : {Status::done, Status::diverged, Status::refused, Status::unrepeatable, Status::cut_off})
        if (name == status_name(status)) return status;
    return Status::missing;
}

std::optional<Errors> errors_from(const Json& e) {
    if (e.is_null()) return std::nullopt;
    return Errors{.eps = real(e.at("eps")), .rms = real(e.at("rms")), .l2 = real(e.at("l2")), .max = real(e.at("max")), .n = e.at("n"), .scale = real(e.at("scale"))};
}

/// What `to_json` of a summary tells, back again.
Summary summary_from(const Json& j) {
    Summary s;
    const std::map<const char*, std::string*> texts{{"title", &s.title}, {"method", &s.method}, {"integrator", &s.integrator}, {"tier", &s.tier}, {"diverged_how", &s.diverged_how}};
    for (const auto& [key, text] : texts) *text = j.at(key).get<std::string>();
    const std::map<const char*, double*> reals{
        {"dt", &s.dt}, {"dt_limit", &s.dt_limit}, {"dt_mild", &s.dt_mild}, {"growth_exponent", &s.growth}, {"neighbours_mean", &s.neighbours_mean},
        {"wall_s", &s.wall_s}, {"cpu_s", &s.cpu_s}, {"setup_s", &s.setup_s}, {"particle_steps", &s.particle_steps}, {"memory_bytes", &s.memory_bytes},
        {"t", &s.t}, {"last_good_t", &s.last_good_t}};
    for (const auto& [key, number] : reals) *number = real(j.at(key));
    j.at("steps").get_to(s.steps);
    j.at("particles").get_to(s.particles);
    j.at("threads").get_to(s.threads);
    j.at("weakly_unstable").get_to(s.weak);
    j.at("diverged").get_to(s.diverged);
    j.at("warnings").get_to(s.warnings);
    s.errors = errors_from(j.at("errors"));
    s.energy_initial = real(j.at("energy").at("initial"));
    s.energy_final = real(j.at("energy").at("final"));
    const Json& active = j.at("active");
    s.asleep_error = real(active.at("error_bound"));
    active.at("all_because").get_to(s.all_because);
    if (const double share = real(active.at("ideal_share")); share < 1) s.ideal_particle_steps = share * real(j.at("nominal_particle_steps"));
    return s;
}

}    // namespace

Json to_json(const StudyRun& run) {
    const StudyResult& r = run.result;
    return {{"point", run.point + 1}, {"repetition", run.repetition}, {"status", status_name(r.status)}, {"why", r.why}, {"took_s", run.took_s},
            {"side_by_side", run.side_by_side}, {"predicted", {{"l2", optional_json(r.predicted_l2)}, {"cpu_s", optional_json(r.predicted_cpu_s)}}},
            {"summary", r.status == Status::refused ? Json(nullptr) : to_json(r.summary)}};
}

StudyRun run_from_json(const Json& line) {
    StudyRun run{.point = line.at("point").get<std::size_t>() - 1, .repetition = line.at("repetition"), .took_s = line.at("took_s"),
                 .side_by_side = line.at("side_by_side"), .result = {.status = status_of(line.at("status")), .why = line.at("why")}};
    run.result.predicted_l2 = optional_real(line.at("predicted").at("l2"));
    run.result.predicted_cpu_s = optional_real(line.at("predicted").at("cpu_s"));
    if (!line.at("summary").is_null()) run.result.summary = summary_from(line.at("summary"));
    return run;
}

}    // namespace sphonic
