#include <algorithm>
#include <cmath>
#include <ranges>

#include <sphonic/atlas.hpp>

namespace sphonic {
namespace {

using Picture = AtlasRow::Picture;

Curve loudness(const AtlasRun& run) { return {.label = run.variant->name, .x = run.t, .y = run.loudness, .point_labels = {}}; }

/// Indices of a profile's particles in the row along x nearest to the middle of the set, by x.
std::vector<std::size_t> middle_row(const AtlasRun& run) {
    const Profile& now = run.last;
    std::vector<std::size_t> row;
    double middle = 0;
    for (const double y : now.x[1]) middle += y / double(now.x[1].size());
    for (std::size_t i = 0; i < now.p.size(); ++i)
        if (now.x[1].empty() || std::abs(now.x[1][i] - middle) <= 0.5 * run.dx) row.push_back(i);
    std::ranges::sort(row, {}, [&](std::size_t i) { return now.x[0][i]; });
    return row;
}

Curve pressure(const AtlasRun& run, bool exact) {
    Curve curve{.label = exact ? "exact" : run.variant->name, .x = {}, .y = {}, .style = exact ? Curve::Style::dashed : Curve::Style::line, .point_labels = {}};
    for (const std::size_t i : middle_row(run)) {
        if (exact && !run.last.in_region[i]) continue;
        curve.x.push_back(run.last.x[0][i]);
        curve.y.push_back(exact ? run.last.exact[i] : run.last.p[i]);
    }
    return curve;
}

Curve places(const AtlasRun& run) {
    return {.label = run.variant->name, .x = run.last.x[0], .y = run.last.x[1], .style = Curve::Style::points, .point_labels = {}};
}

Panel panel_of(const AtlasRow& row, const std::vector<AtlasRun>& runs, const std::string& side) {
    Panel panel{.title = side, .x = {.label = row.picture == Picture::growth ? "t [s]" : "x [m]"}, .y = {}, .curves = {}};
    panel.y.label = row.picture == Picture::growth ? "RMS pressure [Pa]" : row.picture == Picture::profile ? "p [Pa]" : "y [m]";
    panel.y.log = row.picture == Picture::growth;
    for (const AtlasRun& run : runs) {
        if (run.t.empty()) continue;    // refused
        if (row.picture == Picture::growth) panel.curves.push_back(loudness(run));
        if (row.picture == Picture::profile) panel.curves.push_back(pressure(run, false));
        if (row.picture == Picture::places) panel.curves.push_back(places(run));
        if (row.picture == Picture::profile && !run.last.exact.empty() && &run == &runs.back()) panel.curves.push_back(pressure(run, true));
    }
    return panel;
}

/// The same axes for both sides. What has diverged leaves through the top: a thousandth to a thousand times the loudest beginning.
void share_axes(std::vector<Panel>& panels) {
    double begin = 0, left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
    for (const Panel& panel : panels)
        for (const Curve& curve : panel.curves) begin = std::max(begin, curve.y.front());
    for (const Panel& panel : panels)
        for (const Curve& curve : panel.curves)
            for (std::size_t i = 0; i < curve.x.size(); ++i) {
                left = std::min(left, curve.x[i]), right = std::max(right, curve.x[i]);
                if (!std::isfinite(curve.y[i]) || (panel.y.log && (curve.y[i] > 1e3 * begin || curve.y[i] < 1e-3 * begin))) continue;
                low = std::min(low, curve.y[i]), high = std::max(high, curve.y[i]);
            }
    for (Panel& panel : panels) {
        const double margin = panel.y.log ? 0 : 0.05 * (high - low);
        panel.x.lower = left, panel.x.upper = right;
        panel.y.lower = panel.y.log ? low / 1.5 : low - margin;
        panel.y.upper = panel.y.log ? high * 1.5 : high + margin;
    }
}

}    // namespace

std::optional<Chart> atlas_chart(const AtlasRow& row, const AtlasResult& result) {
    Chart chart{.title = row.title, .panels = {}, .width = 1400, .height = 520};
    const auto add = [&](Panel panel) {
        if (!panel.curves.empty()) chart.panels.push_back(std::move(panel));
    };
    for (const auto& [runs, side] : {std::pair{&result.failures, "failure"}, std::pair{&result.cures, "cure"}}) {
        if (row.picture != Picture::places) add(panel_of(row, *runs, side));
        for (std::size_t i = 0; row.picture == Picture::places && i < runs->size(); ++i) add(panel_of(row, {(*runs)[i]}, side));
    }
    if (chart.panels.empty()) return std::nullopt;
    chart.columns = int(chart.panels.size());
    const auto curves = [](const Panel& panel) { return int(panel.curves.size()); };
    chart.height += 40 * std::max(0, std::ranges::max(chart.panels | std::views::transform(curves)) - 4);    // room for the legend
    if (row.fails != Failing::warned) share_axes(chart.panels);
    return chart;
}

}    // namespace sphonic
