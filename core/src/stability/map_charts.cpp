#include <algorithm>
#include <cmath>
#include <map>

#include <sphonic/json.hpp>
#include <sphonic/parameters.hpp>
#include <sphonic/stability_report.hpp>

#include "contour.hpp"

namespace sphonic {
namespace {

using Style = Curve::Style;

constexpr double slow = 0.01;    ///< growth per step up to which it is slow

/// Of the keys that are no plugin's.
const std::map<std::string, std::string> core_labels{
    {"/integrator/dt", "step dt [s]"},          {"/integrator/safety", "dt / limit [1]"},  {"/kernel/h", "smoothing length h [m]"},
    {"/kernel/h_over_dx", "h / dx [1]"},        {"/particles/dx", "spacing dx [m]"},       {"/particles/jitter", "jitter [dx]"},
    {"/particles/seed", "seed [1]"},            {"/until", "until [s]"},                   {"/medium/c0", "sound speed c0 [m/s]"},
    {"/medium/rho0", "density rho0 [kg/m^3]"},  {"/dimension", "dimension [1]"},          {"/dissipation/alpha", "dissipation alpha [1]"}};

}    // namespace

/// With its unit, where the core or the plugin of the same object knows it.
std::string StabilityMap::axis_label(std::size_t parameter) const {
    const std::string& pointer = varied_[parameter].pointer;
    if (pointer == "/integrator/courant") return "Courant number c0 dt / " + courant_length_ + " [1]";
    if (const auto known = core_labels.find(pointer); known != core_labels.end()) return known->second;
    const auto cut = pointer.rfind('/');
    const std::string name = pointer.substr(cut + 1), kind = pointer.substr(1, pointer.find('/', 1) - 1);
    const Json::json_pointer type(pointer.substr(0, cut) + "/type");
    if (std::ranges::find(plugin_kinds(), kind) != plugin_kinds().end() && document_->contains(type))
        for (const abi::ParameterInfo& row : registry_.find(kind, document_->at(type).get<std::string>(), pointer).parameters)
            if (row.name == name) return kind + " " + name + " [" + row.unit + "]";
    return pointer;
}

Chart StabilityMap::chart() const {
    if (varied_.size() == 2) return cell_chart();
    return own_step_ ? growth_chart() : line_chart();
}

/// The limit against a parameter.
Chart StabilityMap::line_chart() const {
    const bool viscous = points_[0].finding.always_on.has_value();
    Curve predicted{.label = viscous ? "predicted, viscosity at half strength" : "predicted", .x = {}, .y = {}, .style = Style::dashed};
    Curve measured{.label = "measured by bisection", .x = {}, .y = {}, .style = Style::points};
    Curve above{.label = "without viscosity", .x = {}, .y = {}}, below{.label = "viscosity always on", .x = {}, .y = {}};
    double highest = 0;
    for (int i = 0; i < points(); ++i) {
        const Point& p = points_[std::size_t(i)];
        const auto add = [&](Curve& curve, double dt) {
            curve.x.push_back(value(i, 0));
            curve.y.push_back(p.courant_per_dt * dt);
            if (std::isfinite(dt)) highest = std::max(highest, curve.y.back());
        };
        add(predicted, p.predicted);
        add(measured, p.finding.measured.dt);
        if (viscous && p.finding.inviscid) add(above, *p.finding.inviscid), add(below, *p.finding.always_on);
    }
    Panel panel{.title = "", .x = {.label = axis_label(0)},
                .y = {.label = "largest stable c0 dt / dx [1]", .lower = 0, .upper = highest > 0 ? 1.15 * highest : 1}, .curves = {measured, predicted}};
    if (viscous) panel.curves.push_back(above), panel.curves.push_back(below);
    return {.title = title_ + ": stable step", .panels = {panel}};
}

/// Growth against the step itself.
Chart StabilityMap::growth_chart() const {
    Curve predicted{.label = "predicted: ln |xi| of the worst mode", .x = {}, .y = {}, .style = Style::dashed};
    Curve measured{.label = "measured", .x = {}, .y = {}, .style = Style::points};
    for (int i = 0; i < points(); ++i) {
        const Point& p = points_[std::size_t(i)];
        for (Curve* curve : {&predicted, &measured}) curve->x.push_back(value(i, 0));
        predicted.y.push_back(p.predicted_growth);
        measured.y.push_back(p.run.growth);
    }
    const Panel panel{.title = "", .x = {.label = axis_label(0)}, .y = {.label = "growth of the amplitude per step, ln [1]"}, .curves = {measured, predicted}};
    return {.title = title_ + ": growth", .panels = {panel}};
}

Chart StabilityMap::cell_chart() const {
    const double width = (varied_[0].to - varied_[0].from) / (varied_[0].count - 1), height = (varied_[1].to - varied_[1].from) / (varied_[1].count - 1);
    std::vector<Curve> cells;
    const bool weak = points_[0].weak;
    for (const char* label : {weak ? "measured: less than e^12 in the run" : "measured: stable", "measured: grows by less than 1 % a step", "measured: grows by 1 % a step or more"})
        cells.push_back({.label = label, .x = {}, .y = {}, .style = Style::cells, .family = int(cells.size()), .cell_width = width, .cell_height = height});
    std::vector<double> x, y, beyond;
    for (int i = 0; i < varied_[0].count; ++i) x.push_back(varied_[0].value(i));
    for (int i = 0; i < varied_[1].count; ++i) y.push_back(varied_[1].value(i));
    for (int i = 0; i < points(); ++i) {
        const Point& p = points_[std::size_t(i)];
        Curve& curve = cells[p.run.stable ? 0 : p.run.growth < slow ? 1 : 2];
        curve.x.push_back(value(i, 0));
        curve.y.push_back(value(i, 1));
        beyond.push_back(std::clamp(std::log(p.dt / p.predicted), -1.0, 1.0));    // 1 where there is no limit
    }
    std::erase_if(cells, [](const Curve& c) { return c.x.empty(); });
    const Lines limit = zero_lines(x, y, beyond);
    cells.push_back({.label = "predicted limit", .x = limit.x, .y = limit.y, .style = Style::dashed});
    const Panel panel{.title = "", .x = {.label = axis_label(0), .lower = x.front() - width / 2, .upper = x.back() + width / 2},
                      .y = {.label = axis_label(1), .lower = y.front() - height / 2, .upper = y.back() + height / 2}, .curves = cells};
    return {.title = title_ + ": stability", .panels = {panel}, .height = 700};
}

Chart spectrum_chart(const Case& scene, const StepTheory& theory, double dt) {
    constexpr int samples = 101;
    Curve values{.label = "eigenvalues of the set", .x = {}, .y = {}, .style = Style::points};
    double left = 0.5, right = 0.2, high = 1;
    for (const auto& value : theory.eigenvalues()) {
        values.x.push_back(value.real() * dt);
        values.y.push_back(value.imag() * dt);
        left = std::max(left, -value.real() * dt), right = std::max(right, value.real() * dt), high = std::max(high, std::abs(value.imag()) * dt);
    }
    const double limit = oscillator_limit(scene);
    high = 1.2 * std::max(high, limit), left = 1.2 * std::max(left, limit > 0 ? 1.2 * limit : 1), right = 1.2 * right;
    std::vector<double> x, y, growth;
    for (int i = 0; i < samples; ++i) x.push_back(-left + (left + right) * i / (samples - 1)), y.push_back(-high + 2 * high * (i + 0.5) / samples);
    const auto grows = [&](double re, double im) { return amplification(scene, std::complex<double>(re, im)) - 1 - 1e-9; };
    for (const double im : y)
        for (const double re : x) growth.push_back(grows(re, im));
    const Lines edge = zero_lines(x, y, growth, grows);
    const Panel panel{.title = "", .x = {.label = "Re(lambda) dt [1]", .lower = -left, .upper = right}, .y = {.label = "Im(lambda) dt [1]", .lower = -high, .upper = high},
                      .curves = {values, {.label = scene.integrator_name + " does not grow inside", .x = edge.x, .y = edge.y, .style = Style::dashed}}};
    char step[60];
    std::snprintf(step, sizeof step, ": spectrum at c0 dt / dx = %.4g", courant_dx(scene, dt));
    return {.title = scene.title + step, .panels = {panel}, .height = 800};
}

}    // namespace sphonic
