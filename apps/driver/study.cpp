#include <algorithm>
#include <iostream>


#include <sphonic/error.hpp>
#include <sphonic/log.hpp>
#include <sphonic/result_folder.hpp>
#include <sphonic/study.hpp>

#include "commands.hpp"
#include "interruption.hpp"
#include "study_bar.hpp"
#include "study_jobs.hpp"
#include "study_page.hpp"

namespace sphonic::driver {
namespace {

namespace fs = std::filesystem;
using Status = StudyResult::Status;

/// Of the same study, interrupted, or else unused.
fs::path default_folder(const Study& study, Registry& registry) {
    const std::string name = study.file.stem().string();
    fs::path latest, next = fs::path("runs") / name;
    for (int number = 2; fs::exists(next); ++number) {
        latest = next;
        next = fs::path("runs") / (name + "-" + std::to_string(number));
    }
    return !latest.empty() && was_interrupted(study, registry, latest) ? latest : next;
}

void print(const Study& study, const std::vector<StudyResult>& results, bool as_json) {
    if (!as_json) {
        const StudyView worst = worst_view(study, results);
        std::cout << study_markdown(worst.study, worst.results);
        return;
    }
    Json points = Json::array();
    for (std::size_t i = 0; i < results.size(); ++i) points.push_back(to_json(study, study.points[i], results[i]));
    std::cout << json_text(points);
}

/// A study is done when any of its points is.
int exit_code(const std::vector<StudyResult>& results) {
    const auto any = [&](Status status) {
        return std::ranges::any_of(results, [&](const auto& r) { return r.status == status; });
    };
    if (any(Status::done)) return 0;
    return int(any(Status::refused) && !any(Status::diverged) ? Fault::input : Fault::diverged);
}

/// Here, one run after the other.
void run_here(const Study& study, Registry& registry, const fs::path& folder, const StudyWork& work) {
    const Interruptible interruptible;
    StudyBar bar;
    run_points(study, registry, folder, work, [&](const StudyProgress& p) {
        bar.show(p);
        interruptible.stop_if_asked(study.file.string(), "in " + counted(p) + "; the runs before it are kept in " + folder.string() + ", and the same command goes on from there");
    });
}

int run_one_point(const Study& study, Registry& registry, const fs::path& folder, const StudyOptions& options) {
    const auto index = std::size_t(options.point) - 1;
    if (index >= study.points.size())
        throw Error(Fault::input, "--point", std::to_string(options.point) + " is not there", study.file.string() + " has " + std::to_string(study.points.size()) + " points");
    if (options.beside) end_with_launcher();
    open_study(study, registry, folder, false, index);
    run_here(study, registry, folder, {.only = index, .side_by_side = options.beside});
    return 0;
}

int tell(const Study& study, const std::vector<StudyResult>& results, const fs::path& folder, const StudyOptions& options) {
    print(study, results, options.json);
    if (options.report) write_study_page(study, results, folder);
    log::info("results in " + folder.string());
    if (const auto missing = std::ranges::count(results, Status::missing, &StudyResult::status))
        log::warn(folder.string() + ": " + std::to_string(missing) + " of " + std::to_string(results.size()) + " points were not run; without --collect they are");
    if (const int code = exit_code(results)) {
        log::error(options.file.string() + ": no point came to its end; " + results[0].why);
        return code;
    }
    return 0;
}

}    // namespace

int study(const StudyOptions& options) {
    Registry registry(Registry::search_path(options.plugin_path));
    Study study = load_study(options.file, options.set);
    if (options.threads) study.threads = options.threads;
    const fs::path folder = options.out.empty() ? default_folder(study, registry) : options.out;
    if (options.point) return run_one_point(study, registry, folder, options);
    if (options.collect && !fs::exists(folder)) throw Error(Fault::io, folder.string(), "is not there", "Give the folder of a study");
    open_study(study, registry, folder, options.force && !options.collect);
    if (!options.launcher.empty()) return write_jobs(study, folder, options);
    if (!options.collect) {
        const std::size_t before = unfinished_points(study, folder).size();
        if (before == 0) log::info(folder.string() + " has all runs of this study already; --force makes them anew");
        if (options.jobs > 1)
            run_jobs(study, folder, options);
        else
            run_here(study, registry, folder, {});
    }
    return tell(study, collect_study(study, folder), folder, options);
}

}    // namespace sphonic::driver
