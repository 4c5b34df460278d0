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
    /// `steps` holds each y until the next x and rings the points; `cells` fills a cell around each point, beneath all lines.
    enum class Style { line, points, line_points, dashed, steps, cells } style = Style::line;
    std::vector<std::string> point_labels;    ///< none, or one per point (may be empty), drawn beside it
    int family = -1;                          ///< curves of the same family share a colour; -1: by position
    double cell_width = 0, cell_height = 0;   ///< of `cells`, on the panel's axes
    std::string colour{};                     ///< of `cells`, "#rrggbb"; empty: by family
};

struct Axis {
    std::string label;    ///< carries the unit: "x [m]"
    bool log = false;
    std::optional<double> lower, upper;    ///< absent: fitted to the visible points with a margin of 5 %
};

/// A field on a grid of cells, drawn as an image: blue below zero, near white at it, red above, darkest at -limit and
/// limit and beyond them. Cells that are not finite are grey.
struct Raster {
    int columns = 0, rows = 0;
    double left = 0, bottom = 0;                  ///< corner of the first cell, on the panel's axes
    double cell_width = 1, cell_height = 1;
    std::vector<double> values;                   ///< row by row from the bottom
    double limit = 1;
    std::string label;                            ///< of the colour bar; carries the unit: "p [Pa]"
};

struct Panel {
    std::string title;
    Axis x, y;
    std::vector<Curve> curves;
    bool legend = true;
    std::optional<Raster> raster{};    ///< beneath the curves: a unit is as long on both axes, and there is no legend
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

/// The height at which rasters fill the width that they have.
int fitting_height(const Chart& chart);

/// Points of a plane, each with a value.
struct Scatter {
    std::span<const double> x, y, value;
};

/// The points as cells. Points on a lattice of this spacing have a cell each; others have finer ones: the set shows.
/// A cell takes the point in it, of several the one of largest magnitude: where cells hold many points, neither a crest
/// nor a sawtooth from point to point is averaged away. A cell without a point takes the nearest, up to 1.5 spacings
/// away, and is NaN beyond. There are at most `most` columns and rows.
Raster raster_of(const Scatter& points, double spacing, int most = 500);

/// Sets the limit to the largest magnitude and the label to `quantity`. Where it is over twice the 99.5 % quantile of the
/// cells that are not silent (0.1 % of it), the colours end at that quantile, and the label says so and how large it gets.
void set_limit(Raster& raster, const std::string& quantity);

/// Writes STEM.png and STEM.svg through gnuplot, each under a temporary name first. Returns false where gnuplot is not
/// installed: then STEM.gp is left, a script with its data inside, to be drawn elsewhere.
bool draw(const Chart& chart, const std::filesystem::path& stem);

/// Indices, sorted by cost, of the points that no other point beats. One point beats another when it is no worse in
/// cost and in error and better in one of them; equal points do not beat each other. NaN and infinities are left out.
std::vector<std::size_t> pareto_front(std::span<const double> cost, std::span<const double> error);

struct CostPoint {
    std::string label, family;
    double cost, error;
    double predicted_cost = 0, predicted_error = 0;    ///< 0: theory says nothing
};

/// An error that is asked for: a line from the left to the cheapest point that meets it.
struct CostTarget {
    double error;
    std::string label;    ///< such as "1 % costs 2 ms"
};

/// Error against cost on logarithmic axes: families by colour and marker, the points of a family that none of it beats full and
/// joined, the others hollow, what is predicted of the joined ones dashed. The Pareto front of all points that such axes can show (both values
/// positive) is a ringed step line. Every point is labelled; of more than 30 those that are best in their family, or best of all.
Chart speed_accuracy_chart(const std::string& title, const std::vector<CostPoint>& points, const std::string& cost_label,
                           const std::string& error_label, const std::vector<CostTarget>& targets = {});

}    // namespace sphonic
