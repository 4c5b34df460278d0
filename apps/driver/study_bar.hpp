#pragma once
#include <chrono>
#include <string>

#include <sphonic/study.hpp>

namespace sphonic::driver {

/// "3/12 NAME", with "run 2 of 3" where there are several.
std::string counted(const StudyProgress& p);
/// "about 3 min left".
std::string left_text(double seconds);

/// The progress of a study: on a terminal one line that is redrawn, elsewhere one line for each run that has ended.
class StudyBar {
public:
    StudyBar();
    ~StudyBar();
    StudyBar(const StudyBar&) = delete;
    StudyBar& operator=(const StudyBar&) = delete;

    void show(const StudyProgress& p);
    /// The same for points that run elsewhere.
    void show(std::size_t done, std::size_t total, double left_s);

private:
    using Clock = std::chrono::steady_clock;
    const bool terminal_;
    bool drawn_ = false;
    Clock::time_point last_{};

    void draw(const std::string& line, bool now);
};

}    // namespace sphonic::driver
