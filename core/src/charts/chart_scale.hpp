#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "sphonic/chart.hpp"

namespace sphonic::charting {

/// Width [px] of UTF-8 text in DejaVu Sans of this size [px]; braces and carets of gnuplot's markup count nothing.
double text_width(std::string_view text, double font);

/// An axis with its limits found.
struct Scale {
    double lower = 0, upper = 1;
    bool log = false;

    bool shows(double value) const;            ///< finite, and positive on a logarithmic axis
    double fraction(double value) const;       ///< 0 at the lower end, 1 at the upper
    bool contains(double value) const { return lower <= value && value <= upper; }
};

struct Tick {
    double at;
    std::string text;    ///< in gnuplot's markup; empty: a minor tick
};

Scale x_scale(const Panel& panel);
Scale y_scale(const Panel& panel);

/// Width [px] of the widest label.
double widest(const std::vector<Tick>& ticks, double font);

/// Ticks of an axis `length` px long, far enough apart for labels side by side (`along`) or above each other.
std::vector<Tick> ticks_of(const Scale& scale, double length, double font, bool along);

}    // namespace sphonic::charting
