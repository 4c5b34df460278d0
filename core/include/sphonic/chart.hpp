#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sphonic {

/// One series. A point that is not finite, or not positive on a logarithmic axis, is a break in the line.
struct Curve {
    std::string label;    ///< in the legend; empty: not in the legend
    std::vector<double> x, y;
    /// `dashed` is for what the others are compared with and is black unless it has a family;
    /// `steps` holds each y until the next x and rings the points.
    enum class Style { line, points, line_points, dashed, steps } style = Style::line;
    std::vector<std::string> point_labels;    ///< none, or one per point (may be empty), drawn beside it
    int family = -1;                          ///< curves of the same family share a colour; -1: by position
};

struct Axis {
    std::string label;    ///< carries the unit: "x [m]"
    bool log = false;
    std::optional<double> lower, upper;    ///< absent: fitted to the visible points with a margin of 5 %
};

struct Panel {
    std::string title;
    Axis x, y;
    std::vector<Curve> curves;
    bool legend = true;
    int span = 1;    ///< columns of the chart that the panel takes
};

/// Panels fill rows of `columns` from the top left. Fonts are 13 pt at 1000 x 600 pixels and grow
/// with the picture, so that it can be scaled down to a page.
struct Chart {
    std::string title;
    std::vector<Panel> panels;
    int columns = 1;
    int width = 1000, height = 600;    ///< whole picture [px]
};

/// Writes STEM.png and STEM.svg through gnuplot, each under a temporary name first. Returns false where gnuplot is not
/// installed: then STEM.gp is left, a script with its data inside, to be drawn elsewhere.
bool draw(const Chart& chart, const std::filesystem::path& stem);

/// Indices, sorted by cost, of the points that no other point beats. One point beats another when it is no worse in
/// cost and in error and better in one of them; equal points do not beat each other. NaN and infinities are left out.
std::vector<std::size_t> pareto_front(std::span<const double> cost, std::span<const double> error);

struct CostPoint {
    std::string label, family;
    double cost, error;
};

/// Error against cost on logarithmic axes: families by colour and marker, every point labelled, and the Pareto front
/// of the points that such axes can show (both values positive) as a ringed step line.
Chart speed_accuracy_chart(const std::string& title, const std::vector<CostPoint>& points,
                           const std::string& cost_label, const std::string& error_label);

}    // namespace sphonic
