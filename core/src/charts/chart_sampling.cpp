#include <algorithm>
#include <cmath>
#include <limits>

#include "sphonic/chart.hpp"
#include "sphonic/error.hpp"
#include "sphonic/shown.hpp"

namespace sphonic {

namespace {

constexpr int finest = 4;              ///< cells per spacing of a set that is no lattice
constexpr double reach = 1.5;          ///< from an empty cell to the point that it takes [spacings]
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct Span {
    double lower = 0, upper = 0;

    explicit Span(std::span<const double> values) {
        const auto [least, most] = std::ranges::minmax_element(values);
        lower = *least, upper = *most;
    }
};

/// Whether all values lie whole spacings from the least.
bool on_lattice(std::span<const double> values, double lower, double spacing) {
    return std::ranges::all_of(values, [&](double v) {
        const double n = (v - lower) / spacing;
        return std::abs(n - std::round(n)) < 1e-5;
    });
}

/// Cells over all points and half a spacing around them.
Raster grid_of(const Scatter& points, double spacing, int most) {
    const Span x(points.x), y(points.y);
    const double width = x.upper - x.lower + spacing, height = y.upper - y.lower + spacing;
    const double larger = std::max(width, height) / spacing;    // side [spacings]
    const bool lattice = on_lattice(points.x, x.lower, spacing) && on_lattice(points.y, y.lower, spacing);
    double cell = spacing * std::max(1.0, std::ceil(larger / most - 1e-6));
    if (!lattice && larger < most) cell = spacing / std::clamp(std::floor(most / larger), 1.0, double(finest));
    Raster grid{.left = x.lower - 0.5 * spacing, .bottom = y.lower - 0.5 * spacing, .values = {}, .label = {}};
    grid.columns = std::clamp(int(std::ceil(width / cell - 1e-6)), 1, most);
    grid.rows = std::clamp(int(std::ceil(height / cell - 1e-6)), 1, most);
    grid.cell_width = lattice ? cell : width / grid.columns;
    grid.cell_height = lattice ? cell : height / grid.rows;
    return grid;
}

int index(double distance, double cell, int count) { return std::clamp(int(distance / cell), 0, count - 1); }

/// For each cell the point that it shows, or -1.
std::vector<long> owners(const Scatter& points, const Raster& grid) {
    std::vector<long> owner(std::size_t(grid.columns) * std::size_t(grid.rows), -1);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        const int column = index(points.x[i] - grid.left, grid.cell_width, grid.columns);
        const int row = index(points.y[i] - grid.bottom, grid.cell_height, grid.rows);
        long& shown = owner[std::size_t(row) * std::size_t(grid.columns) + std::size_t(column)];
        const double before = shown < 0 ? not_a_number : points.value[std::size_t(shown)];
        if (shown < 0 || std::isnan(before) || std::abs(points.value[i]) > std::abs(before)) shown = long(i);
    }
    return owner;
}

/// The nearest point to an empty cell among those that the cells around it show.
long nearest(const Scatter& points, const Raster& grid, const std::vector<long>& owner, int column, int row,
             double radius) {
    const double x = grid.left + (column + 0.5) * grid.cell_width, y = grid.bottom + (row + 0.5) * grid.cell_height;
    const int wide = int(std::ceil(radius / grid.cell_width)), high = int(std::ceil(radius / grid.cell_height));
    long found = -1;
    double least = radius * radius;
    for (int r = std::max(0, row - high); r <= std::min(grid.rows - 1, row + high); ++r)
        for (int c = std::max(0, column - wide); c <= std::min(grid.columns - 1, column + wide); ++c) {
            const long i = owner[std::size_t(r) * std::size_t(grid.columns) + std::size_t(c)];
            if (i < 0) continue;
            const double dx = points.x[std::size_t(i)] - x, dy = points.y[std::size_t(i)] - y, r2 = dx * dx + dy * dy;
            if (r2 < least) least = r2, found = i;
        }
    return found;
}

}    // namespace

Raster raster_of(const Scatter& points, double spacing, int most) {
    const auto n = points.value.size();
    if (n == 0 || points.x.size() != n || points.y.size() != n || !(spacing > 0) || most < 1)
        throw Error(Fault::input, "raster",
                    std::to_string(points.x.size()) + " x and " + std::to_string(points.y.size()) + " y for " +
                        std::to_string(n) + " values at a spacing of " + shown(spacing, 3),
                    "Give at least one point, as many x and y as values, and a positive spacing");
    Raster grid = grid_of(points, spacing, most);
    const std::vector<long> owner = owners(points, grid);
    grid.values.resize(owner.size(), not_a_number);
    for (std::size_t k = 0; k < owner.size(); ++k) {
        const int column = int(k % std::size_t(grid.columns)), row = int(k / std::size_t(grid.columns));
        const long i = owner[k] >= 0 ? owner[k] : nearest(points, grid, owner, column, row, reach * spacing);
        if (i >= 0) grid.values[k] = points.value[std::size_t(i)];
    }
    return grid;
}

void set_limit(Raster& raster, const std::string& quantity) {
    constexpr double silent = 1e-3, kept = 0.995, towering = 2;
    std::vector<double> sizes;
    for (const double value : raster.values)
        if (std::isfinite(value)) sizes.push_back(std::abs(value));
    const double largest = sizes.empty() ? 0 : std::ranges::max(sizes);
    raster.label = quantity;
    raster.limit = std::isnormal(largest) ? largest : 1;
    std::erase_if(sizes, [&](double size) { return size <= silent * largest; });
    if (sizes.empty()) return;
    const auto quantile = sizes.begin() + std::ptrdiff_t(kept * double(sizes.size() - 1));
    std::ranges::nth_element(sizes, quantile);
    if (largest < towering * *quantile) return;
    raster.limit = *quantile;
    raster.label += ", to 99.5 % (max " + shown(largest, 3) + ")";
}

}    // namespace sphonic
