#include <algorithm>
#include <cmath>
#include <fstream>
#include <new>

#include <sphonic/error.hpp>
#include <sphonic/log.hpp>
#include <sphonic/result_folder.hpp>

#include "study_parts.hpp"

namespace fs = std::filesystem;

namespace sphonic {
namespace {

using Status = StudyResult::Status;
using Report = std::function<void(double fraction)>;

bool needs_reference(const Study& study) {
    const auto of_reference = [](const StudyChart& chart) { return measure(chart.y).of_reference; };
    return measure(study.measure).of_reference || std::ranges::any_of(study.charts, of_reference);
}

/// Every case must be readable before the first one runs.
void check_points(const Study& study, Registry& registry) {
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        const StudyPoint& point = study.points[i];
        try {
            const Case scene = load_case(point.document, point.file, registry);
            if (!scene.reference && needs_reference(study))
                throw Error(Fault::input, scene.file + ": /reference", "is missing",
                            "Errors need something to compare with");
        } catch (const Error& e) {
            throw Error(e.fault, point_place(study, i, study.points.size(), point.full_name()), e.what());
        }
    }
}

/// Only what a study left is ever removed.
void open_folder(const fs::path& folder, bool force) {
    const std::string place = folder.string();
    std::error_code failed;
    if (fs::exists(folder)) {
        if (!force) throw Error(Fault::io, place, "exists already", "Give --force to replace it, or another --out");
        if (!fs::is_directory(folder) || (!fs::is_empty(folder) && !fs::exists(folder / "points.jsonl")))
            throw Error(Fault::io, place, "holds something other than a study", "Give another --out");
        fs::remove_all(folder, failed);
    }
    if (!failed) fs::create_directories(folder, failed);
    if (failed) throw Error(Fault::io, place, "cannot be created: " + failed.message(), "Check space and permissions");
}

StudyResult run_once(const StudyPoint& point, int threads, Registry& registry, const Report& report) {
    StudyResult result;
    try {
        Case scene = load_case(point.document, point.file, registry);
        scene.threads = threads;
        Simulation simulation(scene);
        simulation.run([&](const Progress& p) { report(double(p.step) / double(p.steps)); });
        result.summary = simulation.summary();
        result.why = result.summary.diverged_how;
        if (result.summary.diverged) result.status = Status::diverged;
    } catch (const Error& e) {
        if (e.fault != Fault::input && e.fault != Fault::diverged) throw;
        result = {
            .status = e.fault == Fault::input ? Status::refused : Status::diverged, .why = e.what(), .summary = {}};
    } catch (const std::bad_alloc&) {
        result = {.status = Status::refused, .why = "there is not enough memory", .summary = {}};
    }
    return result;
}

bool same(const StudyResult& a, const StudyResult& b) {
    const auto& [ea, eb] = std::pair(a.summary.errors, b.summary.errors);
    const bool errors = ea && eb ? ea->l2 == eb->l2 && ea->max == eb->max : ea.has_value() == eb.has_value();
    return a.status == b.status && a.summary.steps == b.summary.steps && errors;
}

StudyResult run_point(const Study& study, const StudyPoint& point, Registry& registry, const Report& report) {
    std::vector<StudyResult> runs;
    for (int r = 0; r < study.repeat; ++r) {
        runs.push_back(run_once(point, study.threads, registry, [&](double fraction) { report((r + fraction) / study.repeat); }));
        if (runs.back().status != Status::done) return runs.back();
    }
    const bool repeatable = std::ranges::all_of(runs, [&](const StudyResult& run) { return same(run, runs[0]); });
    const auto middle = runs.begin() + (study.repeat - 1) / 2;
    std::ranges::nth_element(runs, middle, {}, [](const StudyResult& run) { return run.summary.cpu_s; });
    if (!repeatable)
        middle->status = Status::unrepeatable, middle->why = "repetitions of this point differ in steps or errors";
    return *middle;
}

class PointFile {
public:
    explicit PointFile(fs::path file) : file_(std::move(file)), out_(file_, std::ios::binary | std::ios::app) {}
    void append(const Json& line) {
        out_ << line.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n' << std::flush;
        if (!out_) throw Error(Fault::io, file_.string(), "cannot be written", "Check space and permissions");
    }

private:
    fs::path file_;
    std::ofstream out_;
};

void write_whole(const fs::path& file, const std::string& text) {
    const fs::path part = file.string() + ".part";
    write_file(part, text);
    fs::rename(part, file);
}

void write_reports(const Study& study, const std::vector<StudyResult>& results, const fs::path& folder) {
    write_whole(folder / "table.csv", study_csv(study, results));
    write_whole(folder / "table.md", study_markdown(study, results));
    bool drawn = true;
    for (const StudyChart& wish : study.charts) drawn &= draw(study_chart(study, wish, results), folder / wish.name);
    if (!drawn) log::warn(folder.string() + ": gnuplot is not installed, so the charts are left as scripts (.gp)");
}

}    // namespace

std::vector<StudyResult> run_study(const Study& study, Registry& registry, const fs::path& folder, bool force,
                                   const std::function<void(const StudyProgress&)>& progress) {
    check_points(study, registry);
    open_folder(folder, force);
    PointFile file(folder / "points.jsonl");
    std::vector<StudyResult> results;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        const StudyPoint& point = study.points[i];
        const auto tell = [&](double fraction, const StudyResult* result) {
            if (progress) progress({i, study.points.size(), point, fraction, result});
        };
        tell(0, nullptr);
        results.push_back(run_point(study, point, registry, [&](double fraction) { tell(fraction, nullptr); }));
        file.append(to_json(study, point, results.back()));
        tell(1, &results.back());
    }
    write_reports(study, results, folder);
    return results;
}

}    // namespace sphonic
