#include <algorithm>
#include <tuple>

#include <sphonic/shown.hpp>

#include "study_parts.hpp"

namespace sphonic {

std::vector<StudyReading> study_readings(const Study& study, const std::vector<StudyResult>& results) {
    std::vector<StudyReading> readings;
    const auto cost = [&](std::size_t i) { return measured(results[i], "cpu_s"); };
    for (const double target : study.targets) {
        const auto first = std::ptrdiff_t(readings.size());
        for (std::size_t i = 0; i < results.size(); ++i) {
            if (!(measured(results[i], study.measure) <= target)) continue;
            const std::string& family = study.points[i].family;
            const auto known = std::find_if(readings.begin() + first, readings.end(), [&](const StudyReading& r) { return r.family == family; });
            if (known == readings.end())
                readings.push_back({target, family, i});
            else if (cost(i) < cost(known->point))
                known->point = i;
        }
        std::sort(readings.begin() + first, readings.end(), [&](const auto& a, const auto& b) { return cost(a.point) < cost(b.point); });
    }
    return readings;
}

std::string target_text(const Study& study, double target) {
    const bool relative = study.measure == "errors.l2" || study.measure == "errors.rms";
    return relative ? shown(100 * target, 3) + " %" : shown(target, 3);
}

std::string time_text(double seconds) {
    for (const auto& [unit, text] : {std::pair{1.0, " s"}, {1e-3, " ms"}, {1e-6, " µs"}})
        if (seconds >= 0.9949 * unit) return shown(seconds / unit, seconds < 100 * unit ? 2 : 3) + text;
    return shown(seconds, 2) + " s";
}

std::string readings_markdown(const Study& study, const std::vector<StudyResult>& results) {
    const auto readings = study_readings(study, results);
    if (readings.empty()) return "";
    std::vector<std::vector<std::string>> rows{{"target", "cheapest of", "point", study.measure.substr(study.measure.find('.') + 1), "CPU [s]"}};
    for (const StudyReading& r : readings) {
        const StudyResult& result = results[r.point];
        rows.push_back({target_text(study, r.target), r.family.empty() ? "all" : r.family, study.points[r.point].name, readable(measured(result, study.measure)),
                        with_digits(measured(result, "cpu_s"), "%.3g")});
    }
    return "## What a target costs\n\n" + markdown_table(rows, 3) + "\n";
}

}    // namespace sphonic
