#include "study_forecast.hpp"

#include <algorithm>

namespace sphonic {

Forecast::Forecast(const Study& study, const StudyRuns& runs) : study_(study), points_(study.points.size(), {study.repeat}) {
    for (const auto& of_point : runs)
        if (!of_point.empty()) note(of_point);
}

void Forecast::note(const std::vector<StudyRun>& of_point) {
    double sum = 0;
    for (const StudyRun& run : of_point) sum += run.took_s;
    points_[of_point[0].point] = {is_finished(study_, of_point) ? 0 : study_.repeat - int(of_point.size()), sum / double(of_point.size())};
}

std::optional<double> Forecast::left() const {
    double known = 0, sum = 0;
    int runs = 0, unknown = 0;
    for (const Point& point : points_) {
        if (!point.each_s) {
            unknown += point.to_come;
            continue;
        }
        known += point.to_come * *point.each_s;
        sum += *point.each_s;
        ++runs;
    }
    if (runs == 0) return std::nullopt;
    return known + unknown * sum / runs;
}

std::optional<double> Forecast::left(std::size_t point) const {
    const Point& p = points_[point];
    return p.each_s ? std::optional(p.to_come * *p.each_s) : std::nullopt;
}

}    // namespace sphonic
