#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "sphonic/chart.hpp"

using namespace sphonic;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct Points {
    std::vector<double> x, y, value;

    Scatter scatter() const { return {.x = x, .y = y, .value = value}; }
    void add(double px, double py, double v) { x.push_back(px), y.push_back(py), value.push_back(v); }
};

/// Columns by rows of a lattice from (-1, 2), each value its index.
Points lattice(int columns, int rows, double spacing) {
    Points points;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) points.add(-1 + c * spacing, 2 + r * spacing, r * columns + c);
    return points;
}

Points jittered(int side, double spacing, double by) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-by * spacing, by * spacing);
    Points points = lattice(side, side, spacing);
    for (std::size_t i = 0; i < points.x.size(); ++i) points.x[i] += shift(random), points.y[i] += shift(random);
    return points;
}

Raster raster(int columns, int rows, const std::vector<double>& values) {
    return {.columns = columns, .rows = rows, .values = values, .label = "p [Pa]"};
}

}    // namespace

TEST_CASE("each point of a lattice has a cell of its own around it") {
    const Points points = lattice(7, 4, 0.1);
    const Raster grid = raster_of(points.scatter(), 0.1);
    CHECK(grid.columns == 7);
    CHECK(grid.rows == 4);
    CHECK(grid.left == Approx(-1.05));
    CHECK(grid.bottom == Approx(1.95));
    CHECK(grid.cell_width == Approx(0.1));
    CHECK(grid.cell_height == Approx(0.1));
    CHECK(grid.values == points.value);
}

TEST_CASE("a large lattice is cut to the cells allowed, and each keeps its largest magnitude with its sign") {
    Points points = lattice(101, 10, 0.1);
    std::ranges::fill(points.value, 0.25);
    points.value[37] = -8;
    for (std::size_t i = 500; i < 600; ++i) points.value[i] = i % 2 ? 3 : -3;    // a sawtooth, whose mean is zero
    const Raster grid = raster_of(points.scatter(), 0.1, 20);
    CHECK(grid.columns <= 20);
    CHECK(grid.cell_width == Approx(0.6));
    CHECK(std::ranges::count(grid.values, -8.0) == 1);
    CHECK(std::ranges::count_if(grid.values, [](double v) { return std::abs(v) == 3; }) >= 100 / 6);
    CHECK(std::ranges::none_of(grid.values, [](double v) { return std::isnan(v); }));
}

TEST_CASE("every cell of a set that is no lattice shows a point near it") {
    const double dx = 0.1;
    const Points points = jittered(20, dx, 0.3);
    const Raster grid = raster_of(points.scatter(), dx);
    CHECK(grid.columns > 40);    // finer than the set
    for (int r = 0; r < grid.rows; ++r)
        for (int c = 0; c < grid.columns; ++c) {
            const double v = grid.values[std::size_t(r * grid.columns + c)];
            REQUIRE(std::isfinite(v));
            const double x = grid.left + (c + 0.5) * grid.cell_width, y = grid.bottom + (r + 0.5) * grid.cell_height;
            double nearest = 1e300;
            for (std::size_t i = 0; i < points.x.size(); ++i)
                nearest = std::min(nearest, std::hypot(points.x[i] - x, points.y[i] - y));
            const auto i = std::size_t(v);    // values are indices
            CHECK(std::hypot(points.x[i] - x, points.y[i] - y) <= nearest + 0.5 * std::hypot(grid.cell_width, grid.cell_height));
        }
}

TEST_CASE("a million irregular points make no more cells than allowed, and none is empty") {
    const Points points = jittered(1000, 0.01, 0.4);
    const Raster grid = raster_of(points.scatter(), 0.01, 500);
    CHECK(std::max(grid.columns, grid.rows) <= 500);
    CHECK(std::ranges::none_of(grid.values, [](double v) { return std::isnan(v); }));
}

TEST_CASE("where there are no points there is no field") {
    Points points = lattice(20, 20, 0.1);
    Points holed;
    for (std::size_t i = 0; i < points.x.size(); ++i)
        if (std::hypot(points.x[i], points.y[i] - 3) > 0.5) holed.add(points.x[i] + 0.01 * double(i % 3), points.y[i], 1);
    const Raster grid = raster_of(holed.scatter(), 0.1);
    const int column = int((0 - grid.left) / grid.cell_width), row = int((3 - grid.bottom) / grid.cell_height);
    CHECK(std::isnan(grid.values[std::size_t(row * grid.columns + column)]));
    CHECK(grid.values.front() == 1);
    CHECK_THROWS_WITH(raster_of({}, 0.1), Catch::Contains("at least one point"));
    CHECK_THROWS_WITH(raster_of(points.scatter(), 0), Catch::Contains("positive spacing"));
}

TEST_CASE("the colours end at the largest magnitude unless a few cells tower over the rest") {
    std::vector<double> wave(10000);
    for (std::size_t i = 0; i < wave.size(); ++i) wave[i] = 2 * std::sin(0.1 * double(i)) - 0.5;
    Raster even = raster(100, 100, wave);
    set_limit(even, "p [Pa]");
    CHECK(even.limit == Approx(2.5).epsilon(1e-3));
    CHECK(even.label == "p [Pa]");
    for (std::size_t i = 0; i < 10; ++i) wave[500 * i] = -700;
    Raster peaked = raster(100, 100, wave);
    set_limit(peaked, "p [Pa]");
    CHECK(peaked.limit == Approx(2.5).epsilon(1e-2));
    CHECK(peaked.label == "p [Pa], to 99.5 % (max 700)");
}

TEST_CASE("a pulse that is small in its box keeps its own scale, and silence has one") {
    std::vector<double> pulse(10000, 0.0);
    for (std::size_t i = 0; i < 20; ++i) pulse[i] = 5 - 0.2 * double(i);
    Raster small = raster(100, 100, pulse);
    set_limit(small, "p [Pa]");
    CHECK(small.limit == 5);
    for (const double nothing : {0.0, not_a_number}) {
        Raster silent = raster(2, 1, {nothing, nothing});
        set_limit(silent, "p [Pa]");
        CHECK(silent.limit == 1);
    }
}
