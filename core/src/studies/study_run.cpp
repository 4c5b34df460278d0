#include <algorithm>
#include <new>

#include <sphonic/error.hpp>
#include <sphonic/prediction.hpp>
#include <sphonic/shown.hpp>

#include "machine.hpp"
#include "study_folder.hpp"
#include "study_forecast.hpp"
#include "study_runs.hpp"

namespace fs = std::filesystem;

namespace sphonic {
namespace {

using Status = StudyResult::Status;
using Report = std::function<void(double fraction)>;

constexpr double warm_up_s = 0.2;    ///< until clocks have risen and code is in the caches

struct EnoughSteps {};

/// As far as the run goes until `enough` says stop.
bool run_while(Simulation& simulation, const std::function<bool()>& enough, const Report& report) {
    try {
        simulation.run([&](const Progress& p) {
            report(double(p.step) / double(p.steps));
            if (p.step < p.steps && enough()) throw EnoughSteps{};
        });
    } catch (const EnoughSteps&) {
        return false;
    }
    return true;
}

void predict_into(StudyResult& result, const Case& scene, const Summary& prepared) {
    const Prediction prediction = predict(scene, prepared);
    result.predicted_l2 = prediction.l2;
    result.predicted_cpu_s = prediction.cpu_s;
}

StudyResult simulate(const Study& study, const StudyPoint& point, Registry& registry, const Report& report) {
    StudyResult result{.status = Status::done};
    Case scene = load_case(point.document, point.file, registry);
    scene.threads = study.threads;
    Simulation simulation(scene);
    predict_into(result, scene, simulation.summary());
    const Summary& summary = simulation.summary();
    const bool ended = run_while(simulation, [&] { return study.cutoff && summary.cpu_s > *study.cutoff; }, report);
    result.summary = summary;
    if (!ended) result.status = Status::cut_off, result.why = "took more than " + shown(*study.cutoff) + " s of CPU time";
    if (summary.diverged) result.status = Status::diverged, result.why = summary.diverged_how;
    return result;
}

StudyResult run_once(const Study& study, const StudyPoint& point, Registry& registry, const Report& report) {
    try {
        return simulate(study, point, registry, report);
    } catch (const Error& e) {
        if (e.fault != Fault::input && e.fault != Fault::diverged) throw;
        return {.status = e.fault == Fault::input ? Status::refused : Status::diverged, .why = e.what()};
    } catch (const std::bad_alloc&) {
        return {.status = Status::refused, .why = "there is not enough memory"};
    }
}

/// Steps a point that is thrown away, again and again if it is short.
void warm_up(const Study& study, const StudyPoint& point, Registry& registry, const Report& report) try {
    Case scene = load_case(point.document, point.file, registry);
    scene.threads = study.threads;
    const double begin = wall_seconds();
    const auto warm = [&] { return wall_seconds() - begin > warm_up_s; };
    while (!warm()) {
        Simulation simulation(scene);
        run_while(simulation, warm, [&](double) { report(0); });
        if (simulation.summary().diverged) return;
    }
} catch (const Error& e) {
    if (e.fault != Fault::input && e.fault != Fault::diverged) throw;
} catch (const std::bad_alloc&) {    // the run itself will say so
}

struct Task {
    std::size_t point;
    int repetition;
};

/// The first repetition of every point, then the second.
std::vector<Task> tasks(const Study& study, const StudyRuns& runs, const StudyWork& work) {
    std::vector<Task> list;
    for (int r = 1; r <= study.repeat; ++r)
        for (std::size_t i = 0; i < study.points.size(); ++i)
            if ((!work.only || *work.only == i) && !is_finished(study, runs[i]) && std::ranges::count(runs[i], r, &StudyRun::repetition) == 0) list.push_back({i, r});
    return list;
}

fs::path run_file(const fs::path& folder, const StudyWork& work) {
    return folder / (work.only ? "runs-" + std::to_string(*work.only + 1) + ".jsonl" : "runs.jsonl");
}

}    // namespace

void run_points(const Study& study, Registry& registry, const fs::path& folder, const StudyWork& work, const StudyListener& listen) {
    StudyRuns runs = read_runs(study, folder);
    const std::vector<Task> list = tasks(study, runs, work);
    if (list.empty()) return;
    RunFile file(run_file(folder, work));
    Forecast forecast(study, runs);
    const auto tell = [&](const Task& task, double fraction, const StudyResult* result) {
        const auto left = work.only ? forecast.left(*work.only) : forecast.left();
        if (listen) listen({task.point, study.points.size(), study.points[task.point], task.repetition, study.repeat, fraction, left, result});
    };
    warm_up(study, study.points[list.front().point], registry, [&](double fraction) { tell(list.front(), fraction, nullptr); });
    for (const Task& task : list) {
        if (is_finished(study, runs[task.point])) continue;    // an earlier repetition failed
        const double begin = wall_seconds();
        tell(task, 0, nullptr);
        StudyRun run{.point = task.point, .repetition = task.repetition, .side_by_side = work.side_by_side, .result = {}};
        run.result = run_once(study, study.points[task.point], registry, [&](double fraction) { tell(task, fraction, nullptr); });
        run.took_s = wall_seconds() - begin;
        file.append(run);
        runs[task.point].push_back(run);
        forecast.note(runs[task.point]);
        tell(task, 1, &run.result);
    }
}

std::vector<std::size_t> unfinished_points(const Study& study, const fs::path& folder) {
    const StudyRuns runs = read_runs(study, folder);
    std::vector<std::size_t> list;
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (!is_finished(study, runs[i])) list.push_back(i);
    return list;
}

std::vector<StudyResult> collect_study(const Study& study, const fs::path& folder) {
    std::vector<StudyResult> results;
    for (const auto& of_point : read_runs(study, folder)) results.push_back(merged(of_point));
    write_tables(study, results, folder);
    return results;
}

std::vector<StudyResult> run_study(const Study& study, Registry& registry, const fs::path& folder, bool force, const StudyListener& listen) {
    open_study(study, registry, folder, force);
    run_points(study, registry, folder, {}, listen);
    return collect_study(study, folder);
}

}    // namespace sphonic
