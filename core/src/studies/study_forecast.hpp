#pragma once
/// How long a study will still take.

#include "study_runs.hpp"

namespace sphonic {

/// Wall time that the runs to come will take: each as long as its point's earlier ones on average, of a point without any as
/// long as all the others'.
class Forecast {
public:
    Forecast(const Study& study, const StudyRuns& runs);
    /// All runs of one point so far.
    void note(const std::vector<StudyRun>& of_point);
    /// Of the study [s]; none before the first run has ended.
    std::optional<double> left() const;
    /// Of one point [s].
    std::optional<double> left(std::size_t point) const;

private:
    struct Point {
        int to_come;
        std::optional<double> each_s{};
    };
    const Study& study_;
    std::vector<Point> points_;
};

}    // namespace sphonic
