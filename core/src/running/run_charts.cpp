#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include <sphonic/run_report.hpp>

#include "sites.hpp"

namespace sphonic {
namespace {

std::string text(const char* format, double value) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

/// The particles' coordinate that is nearest to the middle of the box.
double middle(const Case& scene, const Profile& profile, int axis) {
    const double middle = 0.5 * (scene.box.lower[axis] + scene.box.upper[axis]);
    return *std::min_element(profile.x[axis].begin(), profile.x[axis].end(),
                             [&](double p, double q) { return std::abs(p - middle) < std::abs(q - middle); });
}

/// Particles of the row along x through the middle of the box, by x.
std::vector<std::size_t> middle_row(const Case& scene, const Profile& profile) {
    std::vector<std::size_t> row;
    double nearest[3] = {0, 0, 0};
    for (int a = 1; a < scene.box.dimension; ++a) nearest[a] = middle(scene, profile, a);
    for (std::size_t i = 0; i < profile.p.size(); ++i) {
        bool inside = true;
        for (int a = 1; a < scene.box.dimension; ++a) inside = inside && std::abs(profile.x[a][i] - nearest[a]) < 0.5 * scene.box.dx;
        if (inside) row.push_back(i);
    }
    std::sort(row.begin(), row.end(), [&](auto i, auto j) { return profile.x[0][i] < profile.x[0][j]; });
    return row;
}

struct Row {
    std::vector<double> x, p, exact;
    std::vector<char> in_region;
};

Row row_of(const Case& scene, const Profile& profile) {
    Row row;
    for (const std::size_t i : middle_row(scene, profile)) {
        row.x.push_back(profile.x[0][i]);
        row.p.push_back(profile.p[i]);
        if (!profile.exact.empty()) row.exact.push_back(profile.exact[i]);
        row.in_region.push_back(profile.in_region[i]);
    }
    return row;
}

std::vector<Curve> curves(const Row& row, std::size_t first, std::size_t last, Curve::Style style) {
    const auto part = [&](const std::vector<double>& v) { return std::vector<double>(v.begin() + long(first), v.begin() + long(last)); };
    std::vector<Curve> list{{.label = "sphonic", .x = part(row.x), .y = part(row.p), .style = style, .point_labels = {}}};
    if (!row.exact.empty())
        list.push_back({.label = "exact", .x = part(row.x), .y = part(row.exact), .style = Curve::Style::dashed, .point_labels = {}});
    return list;
}

/// Strict extrema of the exact solution inside the region, farthest apart: the first, a middle and the last.
std::vector<std::size_t> crests(const Row& row) {
    std::vector<std::size_t> found;
    double largest = 0;
    for (const double p : row.exact) largest = std::max(largest, std::abs(p));
    for (std::size_t i = 1; i + 1 < row.exact.size(); ++i) {
        const double before = row.exact[i] - row.exact[i - 1], after = row.exact[i + 1] - row.exact[i];
        if (row.in_region[i] && std::abs(row.exact[i]) > 0.6 * largest && before * after <= 0 && before != 0) found.push_back(i);
    }
    if (found.size() > 3) return {found.front(), found[found.size() / 2], found.back()};
    return found;
}

/// A window of a thirtieth of a wave around a crest.
Panel magnified(const Case& scene, const Row& row, std::size_t crest) {
    double wavelength = row.x.back() - row.x.front();
    for (const SourceUse& use : scene.sources)
        if (const abi::PlaneWave* wave = use.source->wave())
            wavelength = std::min(wavelength, 2 * std::acos(-1.0) * scene.medium.c0 / wave->omega);
    const double half = std::max(wavelength / 25, 6 * scene.box.dx), centre = row.x[crest];
    const auto first = std::lower_bound(row.x.begin(), row.x.end(), centre - half) - row.x.begin();
    const auto last = std::upper_bound(row.x.begin(), row.x.end(), centre + half) - row.x.begin();
    return {.title = (row.exact[crest] > 0 ? "crest" : "trough") + text(" at x = %.3g m", centre), .x = {.label = "x [m]"}, .y = {.label = "p [Pa]"},
            .curves = curves(row, std::size_t(first), std::size_t(last), Curve::Style::line_points), .legend = false};
}

/// The particles of the field's picture; the difference from the reference is NaN outside its region, and everything in solids.
struct Layer {
    std::vector<double> x, y, p, difference;
};

/// Where particles were cut out; in the layer at z, if there is one.
void add_solids(const Case& scene, double z, Layer& layer) {
    const Sites sites(scene);
    for (std::size_t i = 0; i < sites.solid[0].size(); ++i) {
        if (std::isfinite(z) && std::abs(sites.solid[2][i] - z) >= 0.5 * scene.box.dx) continue;
        layer.x.push_back(sites.solid[0][i]);
        layer.y.push_back(sites.solid[1][i]);
        layer.p.push_back(std::numeric_limits<double>::quiet_NaN());
        if (!layer.difference.empty()) layer.difference.push_back(layer.p.back());
    }
}

Layer layer_of(const Case& scene, const Profile& profile) {
    const bool deep = scene.box.dimension == 3;
    const double z = deep ? middle(scene, profile, 2) : 0;
    Layer layer;
    for (std::size_t i = 0; i < profile.p.size(); ++i) {
        if (deep && std::abs(profile.x[2][i] - z) >= 0.5 * scene.box.dx) continue;
        layer.x.push_back(profile.x[0][i]);
        layer.y.push_back(profile.x[1][i]);
        layer.p.push_back(profile.p[i]);
        if (profile.exact.empty()) continue;
        const double outside = std::numeric_limits<double>::quiet_NaN();
        layer.difference.push_back(profile.in_region[i] ? profile.p[i] - profile.exact[i] : outside);
    }
    if (!scene.obstacles.empty()) add_solids(scene, deep ? z : std::numeric_limits<double>::infinity(), layer);
    return layer;
}

Panel picture(const Case& scene, const Layer& layer, const std::vector<double>& values, const std::string& quantity) {
    Panel panel{.title = "", .x = {.label = "x [m]"}, .y = {.label = "y [m]"}, .curves = {}};
    panel.raster = raster_of({.x = layer.x, .y = layer.y, .value = values}, scene.box.dx);
    set_limit(*panel.raster, quantity);
    return panel;
}

}    // namespace

Chart field_chart(const Case& scene, const Summary& summary, const Profile& profile) {
    const Layer layer = layer_of(scene, profile);
    Chart chart{.title = scene.title + text(", t = %.4g s", profile.t), .panels = {}};
    if (scene.box.dimension == 3) {
        const double step = 0.01 * scene.box.dx, z = step * std::round(middle(scene, profile, 2) / step);
        chart.title += text(", z = %.4g m", z + 0.0);
    }
    chart.panels.push_back(picture(scene, layer, layer.p, "p [Pa]"));
    if (!layer.difference.empty()) {
        chart.panels[0].title = "pressure";
        chart.panels.push_back(picture(scene, layer, layer.difference, "p − exact [Pa]"));
        chart.panels[1].title = "difference from exact" + (summary.errors ? text(", L2 error %.3g", summary.errors->l2) : "");
        const Raster& raster = *chart.panels[0].raster;
        const bool wide = raster.columns * raster.cell_width > 1.8 * raster.rows * raster.cell_height;
        if (!wide) chart.columns = 2, chart.width = 1600;
    }
    chart.height = fitting_height(chart);
    return chart;
}

Chart pressure_chart(const Case& scene, const Summary& summary, const Profile& profile) {
    const Row row = row_of(scene, profile);
    Chart chart{.title = scene.title + text(", t = %.4g s", profile.t), .panels = {}, .width = 1200, .height = 500};
    Panel whole{.title = "", .x = {.label = "x [m]"}, .y = {.label = "sound pressure p [Pa]"},
                .curves = curves(row, 0, row.x.size(), Curve::Style::line)};
    if (summary.errors) whole.title = text("L2 error %.3g", summary.errors->l2) + text(", largest %.3g Pa", summary.errors->max);
    const auto peaks = crests(row);
    if (!peaks.empty()) {
        whole.span = chart.columns = int(peaks.size());
        chart.height = 900;
    }
    chart.panels.push_back(std::move(whole));
    for (const std::size_t crest : peaks) chart.panels.push_back(magnified(scene, row, crest));
    return chart;
}

Chart probe_chart(const Case& scene, const ProbeRecord& probes) {
    Chart chart{.title = scene.title + ", receivers", .panels = {}, .width = 1000, .height = 500};
    Panel panel{.title = "", .x = {.label = "t [s]"}, .y = {.label = "sound pressure p [Pa]"}, .curves = {}};
    for (std::size_t k = 0; k < probes.p.size(); ++k) {
        std::string at;
        for (const double x : probes.read_at[k]) at += (at.empty() ? "" : ", ") + text("%.4g", x);
        if (scene.box.dimension > 1) at = "(" + at + ")";
        panel.curves.push_back({.label = "x = " + at + " m", .x = probes.t, .y = probes.p[k], .point_labels = {}, .family = int(k)});
        if (!probes.exact[k].empty())
            panel.curves.push_back({.label = k == 0 ? "exact" : "", .x = probes.t, .y = probes.exact[k],
                                    .style = Curve::Style::dashed, .point_labels = {}});
    }
    chart.panels.push_back(std::move(panel));
    return chart;
}

}    // namespace sphonic
