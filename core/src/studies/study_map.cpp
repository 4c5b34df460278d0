#include <algorithm>
#include <array>
#include <cmath>

#include "study_parts.hpp"

namespace sphonic {
namespace {

/// From small to large: Brewer's YlGnBu.
constexpr std::array colours{"#ffffcc", "#c7e9b4", "#7fcdbb", "#41b6c4", "#1d91c0", "#225ea8", "#0c2c84"};
constexpr const char* failed = "#bbbbbb";

/// The ends of cells around sorted values: half-way between neighbours, on logarithmic axes in the logarithm.
struct Cells {
    std::vector<double> values, ends;

    Cells(const Study& study, const std::string& name, bool log) {
        const auto& dimension = *std::ranges::find(study.vary, name, &StudyDimension::name);
        for (const StudyValue& value : dimension.values) values.push_back(value.label.get<double>());
        std::ranges::sort(values);
        const auto to = [&](double x) { return log ? std::log(x) : x; };
        const auto from = [&](double x) { return log ? std::exp(x) : x; };
        const std::size_t n = values.size();
        ends.push_back(from(1.5 * to(values[0]) - 0.5 * to(values[1])));
        for (std::size_t i = 1; i < n; ++i) ends.push_back(from(0.5 * (to(values[i - 1]) + to(values[i]))));
        ends.push_back(from(1.5 * to(values[n - 1]) - 0.5 * to(values[n - 2])));
    }
    std::size_t index(double x) const { return std::size_t(std::ranges::find(values, x) - values.begin()); }
    double middle(std::size_t i) const { return 0.5 * (ends[i] + ends[i + 1]); }
    double width(std::size_t i) const { return ends[i + 1] - ends[i]; }
};

/// Where classes of values begin and end: 1, 2, 5 of each decade, or fewer, until there are colours enough.
std::vector<double> classes_of(const std::vector<double>& positive) {
    if (positive.empty()) return {};
    const auto [low, high] = std::ranges::minmax(positive);
    for (int decades = 1;; ++decades)
        for (const std::vector<double>& steps : {std::vector<double>{1, 2, 5}, {1, 3}, {1}}) {
            if (decades > 1 && steps.size() > 1) continue;
            std::vector<double> ends;
            const int first = int(std::floor(std::log10(low) / decades)) * decades;
            for (int e = first; ends.empty() || ends.back() <= high; e += decades)
                for (const double step : steps)
                    if (ends.empty() || ends.back() <= high) ends.push_back(std::stod(formatted("%.0fe", step) + std::to_string(e)));
            while (ends.size() > 2 && ends[1] <= low) ends.erase(ends.begin());
            if (ends.size() <= colours.size() + 1) return ends;
        }
}

/// One cell; the first of its class names it in the legend.
Curve cell(const std::string& label, double x, double y, double width, double height, const char* colour) {
    return {.label = label, .x = {x}, .y = {y}, .style = Curve::Style::cells, .point_labels = {}, .cell_width = width, .cell_height = height, .colour = colour};
}

Panel panel_of(const Study& study, const StudyChart& wish, const std::vector<StudyResult>& results, const std::string& name) {
    const Cells x(study, wish.x, wish.x_log), y(study, wish.y, wish.y_log);
    std::vector<double> positive;
    for (const StudyResult& result : results)
        if (const double value = measured(result, name); value > 0 && std::isfinite(value)) positive.push_back(value);
    const std::vector<double> ends = classes_of(positive);
    std::vector<std::vector<Curve>> classes(ends.empty() ? 1 : ends.size());    // the last: no value to show
    for (std::size_t p = 0; p < results.size(); ++p) {
        const double value = measured(results[p], name);
        const std::size_t i = x.index(at_place(study, study.points[p], wish.x)), j = y.index(at_place(study, study.points[p], wish.y));
        std::size_t k = classes.size() - 1;
        if (value > 0) k = std::size_t(std::ranges::upper_bound(ends, value) - ends.begin()) - 1;
        const bool shows = k + 1 < classes.size();
        const std::string label = shows ? formatted("%g", ends[k]) + " to " + formatted("%g", ends[k + 1]) : "no value";
        classes[k].push_back(cell(classes[k].empty() ? label : "", x.middle(i), y.middle(j), x.width(i), y.width(j), shows ? colours[k] : failed));
    }
    Panel panel{.title = measure(name).label, .x = {.label = wish.x_label, .log = wish.x_log, .lower = x.ends.front(), .upper = x.ends.back()},
                .y = {.label = wish.y_label, .log = wish.y_log, .lower = y.ends.front(), .upper = y.ends.back()}, .curves = {}};
    for (auto& curves : classes) std::ranges::move(curves, std::back_inserter(panel.curves));
    return panel;
}

}    // namespace

Chart map_chart(const Study& study, const StudyChart& wish, const std::vector<StudyResult>& results) {
    return {.title = wish.title, .panels = {panel_of(study, wish, results, wish.measure), panel_of(study, wish, results, "cpu_s")}, .columns = 2, .width = 1400, .height = 640};
}

}    // namespace sphonic
