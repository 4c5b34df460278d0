#include "study_bar.hpp"

#include <cmath>
#include <cstdio>

#include <unistd.h>

#include <sphonic/log.hpp>
#include <sphonic/shown.hpp>

namespace sphonic::driver {
namespace {

std::string outcome(const StudyResult& result) {
    if (result.status != StudyResult::Status::done) return result.why;
    return std::to_string(result.summary.steps) + " steps, " + shown(result.summary.cpu_s, 3) + " s";
}

std::string left_of(const StudyProgress& p) { return p.left_s && *p.left_s > 0 ? "; " + left_text(*p.left_s) : ""; }

}    // namespace

std::string counted(const StudyProgress& p) {
    const std::string run = p.repetitions > 1 ? ", run " + std::to_string(p.repetition) + " of " + std::to_string(p.repetitions) : "";
    return std::to_string(p.index + 1) + "/" + std::to_string(p.total) + " " + p.point.full_name() + run;
}

std::string left_text(double seconds) {
    if (seconds < 100) return "about " + shown(std::ceil(seconds), 3) + " s left";
    if (seconds < 6000) return "about " + shown(std::round(seconds / 60), 3) + " min left";
    return "about " + shown(seconds / 3600, 2) + " h left";
}

StudyBar::StudyBar() : terminal_(isatty(STDERR_FILENO)) {}

StudyBar::~StudyBar() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

void StudyBar::show(const StudyProgress& p) {
    if (terminal_)
        draw(counted(p) + " " + shown(std::floor(100 * p.fraction), 3) + " %" + left_of(p), p.result);
    else if (p.result)
        log::info(counted(p) + ": " + outcome(*p.result) + left_of(p));
}

void StudyBar::show(std::size_t done, std::size_t total, double left_s) {
    const std::string line = std::to_string(done) + "/" + std::to_string(total) + " points" + (left_s > 0 ? "; " + left_text(left_s) : "");
    if (terminal_)
        draw(line, true);
    else
        log::info(line);
}

void StudyBar::draw(const std::string& line, bool now) {
    const auto time = Clock::now();
    if (!now && time - last_ < std::chrono::milliseconds(100)) return;
    last_ = time;
    drawn_ = true;
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
    std::fflush(stderr);
}

}    // namespace sphonic::driver
