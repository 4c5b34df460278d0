#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "sphonic/chart.hpp"

namespace sphonic {
namespace {

constexpr std::size_t most_labels = 30;

bool shows(double cost, double error) { return cost > 0 && error > 0 && std::isfinite(cost) && std::isfinite(error); }

/// Of those points of a list that logarithmic axes can show.
std::vector<std::size_t> front_of(const std::vector<CostPoint>& points, const std::vector<std::size_t>& list) {
    std::vector<std::size_t> shown;
    std::vector<double> cost, error;
    for (const std::size_t i : list)
        if (shows(points[i].cost, points[i].error)) shown.push_back(i), cost.push_back(points[i].cost), error.push_back(points[i].error);
    std::vector<std::size_t> front;
    for (const std::size_t k : pareto_front(cost, error)) front.push_back(shown[k]);
    return front;
}

/// What a family looks like: its best points joined and full, the others hollow, what is predicted of the best dashed.
struct Family {
    std::string name;
    std::vector<std::size_t> points, best;
};

std::vector<Family> families_of(const std::vector<CostPoint>& points) {
    std::vector<Family> families;
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto family = std::ranges::find(families, points[i].family, &Family::name);
        if (family == families.end()) family = families.insert(families.end(), {points[i].family, {}, {}});
        family->points.push_back(i);
    }
    for (Family& family : families) family.best = front_of(points, family.points);
    return families;
}

/// The points whose labels there is room for: all, or those that are best in their family, or best of all.
std::set<std::size_t> labelled(const std::vector<CostPoint>& points, const std::vector<Family>& families, const std::vector<std::size_t>& front) {
    std::set<std::size_t> some;
    for (std::size_t i = 0; i < points.size(); ++i) some.insert(i);
    if (some.size() > most_labels) {
        some.clear();
        for (const Family& family : families) some.insert(family.best.begin(), family.best.end());
    }
    if (some.size() > most_labels) some = {front.begin(), front.end()};
    return some;
}

Curve curve_through(const std::vector<CostPoint>& points, const std::vector<std::size_t>& list, const std::set<std::size_t>& named) {
    Curve curve{.label = "", .x = {}, .y = {}, .point_labels = {}};
    for (const std::size_t i : list) {
        curve.x.push_back(points[i].cost);
        curve.y.push_back(points[i].error);
        curve.point_labels.push_back(named.contains(i) ? points[i].label : "");
    }
    return curve;
}

/// Sorted by cost; empty where theory says nothing.
Curve prediction_of(const std::vector<CostPoint>& points, std::vector<std::size_t> list) {
    std::erase_if(list, [&](std::size_t i) { return !shows(points[i].predicted_cost, points[i].predicted_error); });
    std::ranges::sort(list, {}, [&](std::size_t i) { return points[i].predicted_cost; });
    Curve curve{.label = "", .x = {}, .y = {}, .style = Curve::Style::dashed, .point_labels = {}};
    for (const std::size_t i : list) curve.x.push_back(points[i].predicted_cost), curve.y.push_back(points[i].predicted_error);
    return curve;
}

void add_family(Panel& panel, const std::vector<CostPoint>& points, const Family& family, int index, const std::set<std::size_t>& named) {
    std::vector<std::size_t> others = family.points;
    std::erase_if(others, [&](std::size_t i) { return std::ranges::count(family.best, i) > 0; });
    Curve best = curve_through(points, family.best, named), rest = curve_through(points, others, named), theory = prediction_of(points, family.best);
    best.label = family.name;
    best.style = Curve::Style::line_points;
    rest.style = Curve::Style::points;
    for (Curve* curve : {&best, &rest, &theory}) {
        curve->family = index;
        panel.curves.push_back(std::move(*curve));
    }
}

/// From the left edge to the cheapest point that meets the target.
void add_target(Panel& panel, const CostTarget& target, const std::vector<CostPoint>& points, const std::vector<std::size_t>& front) {
    const auto meets = std::ranges::find_if(front, [&](std::size_t i) { return points[i].error <= target.error; });
    if (meets == front.end() || points[front.front()].error <= target.error) return;
    double left = points[front.front()].cost;
    for (const CostPoint& point : points)
        if (shows(point.predicted_cost, point.predicted_error)) left = std::min(left, point.predicted_cost);
    panel.curves.push_back({.label = "", .x = {left, points[*meets].cost}, .y = {target.error, target.error}, .style = Curve::Style::dashed,
                            .point_labels = {target.label, ""}});
}

}    // namespace

Chart speed_accuracy_chart(const std::string& title, const std::vector<CostPoint>& points, const std::string& cost_label,
                           const std::string& error_label, const std::vector<CostTarget>& targets) {
    Panel panel;
    panel.x = {.label = cost_label, .log = true, .lower = {}, .upper = {}};
    panel.y = {.label = error_label, .log = true, .lower = {}, .upper = {}};
    const std::vector<Family> families = families_of(points);
    std::vector<std::size_t> all(points.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const std::vector<std::size_t> front = front_of(points, all);
    const std::set<std::size_t> named = labelled(points, families, front);
    int index = 0;
    for (const Family& family : families) add_family(panel, points, family, index++, named);
    Curve best_of_all = curve_through(points, front, {});
    best_of_all.label = "Pareto front";
    best_of_all.style = Curve::Style::steps;
    best_of_all.point_labels.clear();
    panel.curves.push_back(std::move(best_of_all));
    if (std::ranges::any_of(points, [](const CostPoint& p) { return shows(p.predicted_cost, p.predicted_error); }))
        panel.curves.push_back({.label = "dashed: predicted", .x = {}, .y = {}, .style = Curve::Style::dashed, .point_labels = {}});
    for (const CostTarget& target : targets) add_target(panel, target, points, front);
    return {.title = title, .panels = {panel}, .columns = 1, .width = 1000, .height = 700};
}

}    // namespace sphonic
