#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>

#include <unistd.h>

#include <sphonic/error.hpp>
#include <sphonic/log.hpp>
#include <sphonic/result_folder.hpp>
#include <sphonic/study.hpp>

#include "commands.hpp"
#include "interruption.hpp"

namespace sphonic::driver {
namespace {

using Status = StudyResult::Status;
using Clock = std::chrono::steady_clock;

/// On a terminal one line that is redrawn, elsewhere one line for each point that is done.
class StudyBar {
public:
    StudyBar() : terminal_(isatty(STDERR_FILENO)) {}
    ~StudyBar() {
        if (drawn_) std::fputs("\r\033[K", stderr);
    }

    void show(const StudyProgress& p) {
        if (terminal_)
            draw(p);
        else if (p.result)
            log::info(counted(p) + ": " + outcome(*p.result));
    }

    /// "3/12 NAME".
    static std::string counted(const StudyProgress& p) {
        return std::to_string(p.index + 1) + "/" + std::to_string(p.total) + " " + p.point.full_name();
    }

private:
    const bool terminal_;
    const Clock::time_point begin_ = Clock::now();
    Clock::time_point last_{};
    bool drawn_ = false;

    static std::string outcome(const StudyResult& result) {
        if (result.status != Status::done) return result.why;
        char text[80];
        std::snprintf(text, sizeof text, "%ld steps, %.3g s", result.summary.steps, result.summary.cpu_s);
        return text;
    }

    void draw(const StudyProgress& p) {
        const auto now = Clock::now();
        if (now - last_ < std::chrono::milliseconds(100)) return;
        last_ = now;
        drawn_ = true;
        const double spent = std::chrono::duration<double>(now - begin_).count();
        const double done = (double(p.index) + p.fraction) / double(p.total);
        std::fprintf(stderr, "\r\033[K%s %3.0f %%", counted(p).c_str(), 100 * p.fraction);
        if (done > 0) std::fprintf(stderr, "  about %.0f s left", spent * (1 - done) / done);
        std::fflush(stderr);
    }
};

void print(const Study& study, const std::vector<StudyResult>& results, bool as_json) {
    if (!as_json) {
        std::cout << study_markdown(study, results);
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

}    // namespace

int study(const RunOptions& options) {
    const Interruptible interruptible;
    Registry registry(Registry::search_path(options.plugin_path));
    Study study = load_study(options.file, options.set);
    if (options.threads) study.threads = options.threads;
    const auto folder = options.out.empty() ? ResultFolder::unused(options.file.stem().string()) : options.out;
    std::vector<StudyResult> results;
    {
        StudyBar bar;
        results = run_study(study, registry, folder, options.force, [&](const StudyProgress& p) {
            bar.show(p);
            interruptible.stop_if_asked(options.file.string(), "in " + StudyBar::counted(p) + "; the points before it are kept in " + folder.string());
        });
    }
    print(study, results, options.json);
    log::info("results in " + folder.string());
    if (const int code = exit_code(results)) {
        log::error(options.file.string() + ": no point came to its end; " + results[0].why);
        return code;
    }
    return 0;
}

}    // namespace sphonic::driver
