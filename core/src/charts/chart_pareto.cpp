#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "sphonic/chart.hpp"
#include "sphonic/error.hpp"

namespace sphonic {

std::vector<std::size_t> pareto_front(std::span<const double> cost, std::span<const double> error) {
    if (cost.size() != error.size())
        throw Error(Fault::input, "Pareto front",
                    std::to_string(cost.size()) + " costs for " + std::to_string(error.size()) + " errors",
                    "Give one cost and one error per point");
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < cost.size(); ++i)
        if (std::isfinite(cost[i]) && std::isfinite(error[i])) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(cost[i], error[i], i); });

    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        const bool better = front.empty() || error[i] < error[front.back()];
        const bool equal = !front.empty() && error[i] == error[front.back()] && cost[i] == cost[front.back()];
        if (better || equal) front.push_back(i);
    }
    return front;
}

namespace {

Curve front_of(const std::vector<CostPoint>& points) {
    std::vector<double> cost, error;
    for (const CostPoint& p : points)
        if (p.cost > 0 && p.error > 0) {
            cost.push_back(p.cost);
            error.push_back(p.error);
        }
    Curve front{.label = "Pareto front", .x = {}, .y = {}, .style = Curve::Style::steps, .point_labels = {}};
    for (const std::size_t i : pareto_front(cost, error)) {
        front.x.push_back(cost[i]);
        front.y.push_back(error[i]);
    }
    return front;
}

}    // namespace

Chart speed_accuracy_chart(const std::string& title, const std::vector<CostPoint>& points,
                           const std::string& cost_label, const std::string& error_label) {
    Panel panel;
    panel.x = {.label = cost_label, .log = true, .lower = {}, .upper = {}};
    panel.y = {.label = error_label, .log = true, .lower = {}, .upper = {}};
    for (const CostPoint& p : points) {
        auto curve = std::ranges::find(panel.curves, p.family, &Curve::label);
        if (curve == panel.curves.end()) {
            panel.curves.push_back({.label = p.family, .x = {}, .y = {}, .style = Curve::Style::points,
                                    .point_labels = {}});
            curve = panel.curves.end() - 1;
        }
        curve->x.push_back(p.cost);
        curve->y.push_back(p.error);
        curve->point_labels.push_back(p.label);
    }
    panel.curves.push_back(front_of(points));
    return {.title = title, .panels = {panel}, .columns = 1, .width = 1000, .height = 700};
}

}    // namespace sphonic
