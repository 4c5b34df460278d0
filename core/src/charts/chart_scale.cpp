#include "chart_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sphonic/error.hpp"

namespace sphonic::charting {

double text_width(std::string_view text, double font) {
    double em = 0;
    for (const char c : text) {
        if ((c & 0xC0) == 0x80 || c == '^' || c == '{' || c == '}') continue;
        if (std::string_view(" .,:;'|!iljIft()[]/\\-").find(c) != std::string_view::npos) em += 0.36;
        else if (c == 'm' || c == 'w' || c == 'M' || c == 'W' || c == '@' || c == '%') em += 0.97;
        else if ('A' <= c && c <= 'Z') em += 0.70;
        else em += 0.62;
    }
    return em * font;
}

bool Scale::shows(double value) const { return std::isfinite(value) && (!log || value > 0); }

double Scale::fraction(double value) const {
    return log ? std::log(value / lower) / std::log(upper / lower) : (value - lower) / (upper - lower);
}

namespace {

using Values = std::vector<double> Curve::*;

void check(const Axis& axis) {
    const std::string place = "chart axis \"" + axis.label + "\"";
    for (const auto& limit : {axis.lower, axis.upper})
        if (limit && (!std::isfinite(*limit) || (axis.log && *limit <= 0)))
            throw Error(Fault::input, place, "the limit " + std::to_string(*limit) + " is not on the axis",
                        axis.log ? "A logarithmic axis needs positive limits" : "Give a finite limit");
    if (axis.lower && axis.upper && *axis.lower >= *axis.upper)
        throw Error(Fault::input, place,
                    "lower " + std::to_string(*axis.lower) + " is not below upper " + std::to_string(*axis.upper),
                    "Exchange or remove the limits");
}

/// Smallest and largest value on `axis` of the points inside the limits given for the `other` axis.
Scale extent(const Panel& panel, const Axis& axis, Values values, const Axis& other, Values others) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Scale here{0, 1, axis.log}, there{0, 1, other.log};
    Scale found{infinity, -infinity, axis.log};
    for (const Curve& curve : panel.curves)
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            const double v = (curve.*values)[i], o = (curve.*others)[i];
            if (!here.shows(v) || !there.shows(o)) continue;
            if (o < other.lower.value_or(-infinity) || o > other.upper.value_or(infinity)) continue;
            found.lower = std::min(found.lower, v);
            found.upper = std::max(found.upper, v);
        }
    return found;
}

Scale fit(const Axis& axis, Scale found) {
    check(axis);
    if (found.lower > found.upper) found = {axis.log ? 0.1 : 0, 1, axis.log};
    found.lower = axis.lower.value_or(found.lower);
    found.upper = axis.upper.value_or(found.upper);
    constexpr double margin = 0.05;
    if (axis.log) {
        const double ratio = found.upper > found.lower ? std::pow(found.upper / found.lower, margin) : 2;
        return {axis.lower.value_or(found.lower / ratio),
                axis.upper.value_or(std::max(found.upper, found.lower) * ratio), true};
    }
    const double size = std::max(std::abs(found.lower), std::abs(found.upper));
    const double flat = size > 0 ? 0.1 * size : 1;
    const bool wide = found.upper - found.lower > 1e-12 * size;
    const double pad = wide ? margin * (found.upper - found.lower) : flat;
    return {axis.lower.value_or(std::min(found.lower, found.upper) - pad),
            axis.upper.value_or(std::max(found.lower, found.upper) + pad), false};
}

}    // namespace

Scale x_scale(const Panel& panel) {
    if (const auto& r = panel.raster) return {r->left, r->left + r->columns * r->cell_width, false};
    return fit(panel.x, extent(panel, panel.x, &Curve::x, panel.y, &Curve::y));
}

Scale y_scale(const Panel& panel) {
    if (const auto& r = panel.raster) return {r->bottom, r->bottom + r->rows * r->cell_height, false};
    return fit(panel.y, extent(panel, panel.y, &Curve::y, panel.x, &Curve::x));
}

}    // namespace sphonic::charting
