#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>

#include "sphonic/chart.hpp"

using namespace sphonic;
namespace fs = std::filesystem;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Raster raster(int columns, int rows, const std::vector<double>& values) {
    return {.columns = columns, .rows = rows, .values = values, .label = "p [Pa]"};
}

Chart chart_of(const Raster& raster) {
    Chart chart{.title = "field", .panels = {Panel{}}};
    chart.panels[0].x.label = "x [m]";
    chart.panels[0].y.label = "y [m]";
    chart.panels[0].raster = raster;
    return chart;
}

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Drawn {
    bool done;
    std::string png, svg, script;
};

/// A chart drawn, or with `installed` false as where gnuplot is not there.
Drawn drawn(const Chart& chart, bool installed = true) {
    const fs::path folder = fs::temp_directory_path() / ("sphonic_raster_" + std::to_string(getpid()));
    fs::create_directory(folder);
    const std::string path = std::getenv("PATH");
    if (!installed) setenv("PATH", folder.c_str(), 1);
    const bool done = draw(chart, folder / "field");
    setenv("PATH", path.c_str(), 1);
    const Drawn files{done, content(folder / "field.png"), content(folder / "field.svg"), content(folder / "field.gp")};
    fs::remove_all(folder);
    if (installed && !done) WARN("gnuplot is not installed: nothing was drawn");
    return files;
}

/// A number that follows a word in a script.
double after(const std::string& script, const std::string& word) {
    const auto at = script.find(word);
    REQUIRE(at != std::string::npos);
    return std::strtod(script.c_str() + at + word.size(), nullptr);
}

}    // namespace

TEST_CASE("without gnuplot the script holds the cells as thousandths of the limit, with gaps") {
    Raster cells = raster(3, 2, {0, 1, -2, 4, -40, not_a_number});
    cells.limit = 4;
    cells.left = -1.5;
    const Drawn files = drawn(chart_of(cells), false);
    CHECK_FALSE(files.done);
    CHECK_THAT(files.script, Catch::Contains("$raster0 << END\n0 250 -500\n1000 -1000 NaN\nEND\n"));
    CHECK_THAT(files.script, Catch::Contains("matrix using (-1+$1*1):(0.5+$2*1):($3*0.004) with image"));
    CHECK_THAT(files.script, Catch::Contains("set cbrange [-4:4]"));
}

TEST_CASE("a unit is as long on both axes of a raster, whatever the picture's shape") {
    for (const auto& [columns, rows] : {std::pair{40, 10}, std::pair{10, 40}, std::pair{300, 3}})
        for (const int height : {300, 700, 1500}) {
            Chart chart = chart_of(raster(columns, rows, std::vector<double>(std::size_t(columns * rows), 0.5)));
            chart.height = height;
            const std::string script = drawn(chart, false).script;
            const double wide = after(script, "set rmargin at screen ") - after(script, "set lmargin at screen ");
            const double high = after(script, "set tmargin at screen ") - after(script, "set bmargin at screen ");
            CHECK(wide * chart.width / columns == Approx(high * chart.height / rows));
        }
}

TEST_CASE("at the fitting height the raster takes the width that it has") {
    const auto width = [](const Chart& chart) {
        const std::string script = drawn(chart, false).script;
        return (after(script, "set rmargin at screen ") - after(script, "set lmargin at screen ")) * chart.width;
    };
    for (const int rows : {10, 50, 60}) {
        Chart chart = chart_of(raster(50, rows, std::vector<double>(std::size_t(50 * rows), 0.5)));
        chart.height = fitting_height(chart);
        CHECK(width(chart) > 0.7 * chart.width);
    }
    Chart strip = chart_of(raster(500, 2, std::vector<double>(1000, 0.5)));
    CHECK(fitting_height(strip) >= 300);    // the colour bar needs some
}

TEST_CASE("cells are filled around their points, beneath the lines, with the legend outside") {
    Chart chart{.title = "map", .panels = {Panel{}}};
    chart.panels[0].x = {.label = "h / dx [1]", .lower = 0.5, .upper = 2.5};
    chart.panels[0].y = {.label = "c0 dt / dx [1]", .lower = 0.75, .upper = 1.75};
    chart.panels[0].curves = {{.label = "limit", .x = {1, 2}, .y = {1, 1.5}, .style = Curve::Style::dashed},
                              {.label = "stable", .x = {1, 2, 1, 2}, .y = {1, 1, 1.5, 1.5}, .style = Curve::Style::cells, .family = 0, .cell_width = 1, .cell_height = 0.5}};
    const std::string script = drawn(chart, false).script;
    const auto cells = script.find(":(0.5):(0.25) with boxxyerror");
    REQUIRE(cells != std::string::npos);
    CHECK(cells < script.find("using 1:2 with lines"));
    CHECK(script.find(" center bottom") != std::string::npos);
    CHECK(drawn(chart).svg.find("stable") != std::string::npos);
}

TEST_CASE("a drawn raster is an image in both files, of modest size, with the texts verbatim") {
    const int side = 500;
    std::vector<double> values;
    for (int r = 0; r < side; ++r)
        for (int c = 0; c < side; ++c) values.push_back(std::sin(0.0007 * r * c));
    Raster cells = raster(side, side, values);
    cells.label = R"(p_0 ^2 'it' [Pa] \n)";
    Chart chart = chart_of(cells);
    chart.height = 900;
    const Drawn files = drawn(chart), again = drawn(chart);
    if (!files.done) return;
    CHECK(files.png.starts_with("\x89PNG\r\n\x1a\n"));
    CHECK(files.png.size() < 1000000);
    CHECK_THAT(files.svg, Catch::Contains("<image") && Catch::Contains(cells.label + "</text>"));
    CHECK(files.svg.size() < 1000000);
    CHECK(files.png == again.png);
    CHECK(files.svg == again.svg);
}

TEST_CASE("a raster that cannot be meant is refused with the place and the values") {
    const Raster good = raster(2, 1, {1, 2});
    Raster bad = good;
    bad.rows = 2;
    CHECK_THROWS_WITH(draw(chart_of(bad), "unused"), Catch::Contains("raster \"p [Pa]\"") && Catch::Contains("2 values for 2 x 2"));
    bad = good;
    bad.limit = 0;
    CHECK_THROWS_WITH(draw(chart_of(bad), "unused"), Catch::Contains("positive finite"));
    bad = good;
    bad.cell_height = not_a_number;
    CHECK_THROWS_WITH(draw(chart_of(bad), "unused"), Catch::Contains("positive finite"));
    Chart log = chart_of(good);
    log.panels[0].x.log = true;
    CHECK_THROWS_WITH(draw(log, "unused"), Catch::Contains("linear axes"));
}
