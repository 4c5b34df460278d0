#include <algorithm>
#include <cmath>
#include <optional>

#include "study_parts.hpp"

namespace sphonic {
namespace {

struct Series {
    std::string label;
    std::vector<std::size_t> points;    ///< along x
};

std::string series_name(const Study& study, const StudyChart& wish, const StudyPoint& point) {
    return wish.group.empty() ? joined_labels(study, point.labels, wish.x)
                              : named_label(wish.group, at_place(study, point, wish.group));
}

std::vector<Series> series_of(const Study& study, const StudyChart& wish) {
    std::vector<Series> list;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        if (!at_place(study, study.points[i], wish.x).is_number()) continue;
        const std::string name = series_name(study, wish, study.points[i]);
        auto series = std::ranges::find(list, name, &Series::label);
        if (series == list.end()) series = list.insert(list.end(), {name, {}});
        series->points.push_back(i);
    }
    const auto x = [&](std::size_t i) { return at_place(study, study.points[i], wish.x).get<double>(); };
    for (Series& series : list) std::ranges::stable_sort(series.points, {}, x);
    return list;
}

/// A triangle of the order's slope below the lowest curve, over the middle of its width.
std::optional<Curve> order_triangle(const std::vector<Curve>& curves, double order) {
    constexpr double begin = 0.4, end = 0.7, below = 0.5;
    const Curve* lowest = nullptr;
    const auto plotted = [](const Curve& c) { return c.x.size() > 1 && c.x.front() > 0 && std::ranges::all_of(c.y, [](double y) { return y > 0; }); };
    for (const Curve& curve : curves)
        if (plotted(curve) && (!lowest || curve.y.front() < lowest->y.front())) lowest = &curve;
    if (!lowest) return std::nullopt;
    const double span = std::log(lowest->x.back() / lowest->x.front());
    const double left = lowest->x.front() * std::exp(begin * span), right = lowest->x.front() * std::exp(end * span);
    std::size_t next = 1;
    while (lowest->x[next] < left && next + 1 < lowest->x.size()) ++next;
    const double part = std::log(left / lowest->x[next - 1]) / std::log(lowest->x[next] / lowest->x[next - 1]);
    const double y = below * std::exp(std::lerp(std::log(lowest->y[next - 1]), std::log(lowest->y[next]), part)), rise = y * std::pow(right / left, order);
    const bool falls = order < 0;
    return Curve{.label = "", .x = {left, right, falls ? left : right, left}, .y = {y, falls ? rise : y, falls ? rise : rise, y}, .style = Curve::Style::dashed,
                 .point_labels = {"", "order " + readable(std::abs(order)), "", ""}};
}

/// The power of x with which a curve goes, by least squares of the logarithms; none where it has too few points that show.
std::optional<double> slope_of(const Curve& curve) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!(curve.x[i] > 0 && curve.y[i] > 0)) continue;
        const double x = std::log(curve.x[i]), y = std::log(curve.y[i]);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double spread = n * sxx - sx * sx;
    if (n < 2 || spread <= 1e-12 * n * sxx) return std::nullopt;
    return (n * sxy - sx * sy) / spread;
}

/// A curve of ours for each series, and hollow points of the same colour for what is printed.
Chart value_chart(const Study& study, const StudyChart& wish, const std::vector<StudyResult>& results) {
    Panel panel;
    panel.x = {.label = wish.x_label, .log = wish.x_log, .lower = {}, .upper = {}};
    panel.y = {.label = wish.y_label, .log = wish.y_log, .lower = {}, .upper = {}};
    int family = 0;
    for (const Series& series : series_of(study, wish)) {
        Curve ours{.label = series.label,
                   .x = {},
                   .y = {},
                   .style = Curve::Style::line_points,
                   .point_labels = {},
                   .family = family};
        Curve printed{.label = series.label + (series.label.empty() ? "printed" : ", printed"),
                      .x = {},
                      .y = {},
                      .style = Curve::Style::points,
                      .point_labels = {},
                      .family = family++};
        for (const std::size_t i : series.points) {
            const double x = at_place(study, study.points[i], wish.x).get<double>();
            ours.x.push_back(x);
            ours.y.push_back(measured(results[i], wish.y));
            if (!study.points[i].printed || wish.y != study.measure) continue;
            printed.x.push_back(x);
            printed.y.push_back(*study.points[i].printed);
        }
        if (const auto slope = wish.slopes ? slope_of(ours) : std::nullopt)
            ours.label += (ours.label.empty() ? "slope " : ", slope ") + formatted("%.2f", *slope);
        panel.curves.push_back(std::move(ours));
        if (!printed.x.empty()) panel.curves.push_back(std::move(printed));
    }
    if (wish.order != 0)
        if (auto triangle = order_triangle(panel.curves, wish.order)) panel.curves.push_back(std::move(*triangle));
    return {.title = wish.title, .panels = {panel}};
}

/// "1 % costs 0.0018 s", for the targets that a point meets.
std::vector<CostTarget> targets_of(const Study& study, const std::vector<StudyResult>& results) {
    std::vector<CostTarget> targets;
    for (const StudyReading& r : study_readings(study, results))
        if (targets.empty() || targets.back().error != r.target)
            targets.push_back({r.target, target_text(study, r.target) + " costs " + time_text(measured(results[r.point], "cpu_s"))});
    return targets;
}

Chart cost_chart(const Study& study, const StudyChart& wish, const std::vector<StudyResult>& results) {
    std::vector<CostPoint> points;
    const auto shown_at = [&](double y) { return y < wish.y_floor ? wish.y_floor : y; };
    for (std::size_t i = 0; i < results.size(); ++i) {
        const double y = measured(results[i], wish.y);
        CostPoint point{study.points[i].name, named_label(wish.group, at_place(study, study.points[i], wish.group)), measured(results[i], "cpu_s"), shown_at(y)};
        if (y < wish.y_floor) point.label += ": " + readable(y);
        if (wish.y == "errors.l2" && results[i].predicted_l2 && results[i].status == StudyResult::Status::done) {
            point.predicted_cost = results[i].predicted_cpu_s.value_or(0);
            point.predicted_error = shown_at(*results[i].predicted_l2);
        }
        points.push_back(std::move(point));
    }
    const auto targets = wish.y == study.measure ? targets_of(study, results) : std::vector<CostTarget>{};
    Chart chart = speed_accuracy_chart(wish.title, points, wish.x_label, wish.y_label, targets);
    if (wish.y_floor > 0) chart.panels[0].y.lower = 0.7 * wish.y_floor;
    return chart;
}

}    // namespace

Chart study_chart(const Study& study, const StudyChart& wish, const std::vector<StudyResult>& results) {
    if (wish.type == StudyChart::Type::map) return map_chart(study, wish, results);
    return wish.type == StudyChart::Type::cost ? cost_chart(study, wish, results) : value_chart(study, wish, results);
}

}    // namespace sphonic
