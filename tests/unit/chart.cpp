#include "sphonic/chart.hpp"

#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include "sphonic/error.hpp"

using namespace sphonic;
namespace fs = std::filesystem;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Folder {
    fs::path path = fs::temp_directory_path() / ("sphonic_chart_" + std::to_string(getpid()));
    Folder() { fs::create_directory(path); }
    ~Folder() { fs::remove_all(path); }
};

struct SearchPath {
    const std::string before = std::getenv("PATH");
    explicit SearchPath(const fs::path& folder) { setenv("PATH", folder.c_str(), 1); }
    ~SearchPath() { setenv("PATH", before.c_str(), 1); }
};

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

Curve curve(const std::string& label, const std::vector<double>& x, const std::vector<double>& y) {
    return {.label = label, .x = x, .y = y, .point_labels = {}};
}

Chart chart_of(const Curve& curve, bool log = false) {
    Chart chart{.title = "", .panels = {Panel{}}};
    Panel& panel = chart.panels[0];
    panel.x.label = "x [m]";
    panel.y.label = "p [Pa]";
    panel.x.log = panel.y.log = log;
    panel.curves = {curve};
    return chart;
}

/// The SVG of a chart, or nothing where gnuplot is missing.
std::string svg_of(const Chart& chart) {
    const Folder folder;
    if (!draw(chart, folder.path / "chart")) {
        WARN("gnuplot is not installed: nothing was drawn");
        return {};
    }
    return content(folder.path / "chart.svg");
}

bool beats(double cost, double error, double other_cost, double other_error) {
    return cost <= other_cost && error <= other_error && (cost < other_cost || error < other_error);
}

}    // namespace

TEST_CASE("no point beats a member of the Pareto front and every other point is beaten by a member") {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> digit(0, 12);    // coarse, so that there are ties
    for (int round = 0; round < 200; ++round) {
        std::vector<double> cost(30), error(30);
        for (std::size_t i = 0; i < cost.size(); ++i) cost[i] = digit(random), error[i] = digit(random);
        const auto front = pareto_front(cost, error);
        CHECK_FALSE(front.empty());
        for (std::size_t i = 0; i < cost.size(); ++i) {
            const bool member = std::ranges::find(front, i) != front.end();
            bool by_any = false, by_member = false;
            for (std::size_t j = 0; j < cost.size(); ++j) by_any |= beats(cost[j], error[j], cost[i], error[i]);
            for (const std::size_t j : front) by_member |= beats(cost[j], error[j], cost[i], error[i]);
            REQUIRE(by_any == !member);
            REQUIRE(by_member == !member);
        }
        CHECK(std::ranges::is_sorted(front, {}, [&](std::size_t i) { return cost[i]; }));
    }
}

TEST_CASE("equal points share the Pareto front, and points that are not finite are never on it") {
    using Indices = std::vector<std::size_t>;
    const std::vector<double> cost{2, 1, 2, 2}, error{1, 3, 1, 2};
    CHECK((pareto_front(cost, error) == Indices{1, 0, 2}));
    const std::vector<double> odd_cost{not_a_number, 0, -infinity, 1}, odd_error{0, not_a_number, 0, 1};
    CHECK((pareto_front(odd_cost, odd_error) == Indices{3}));
    CHECK(pareto_front({}, {}).empty());
    CHECK_THROWS_WITH(pareto_front(cost, {}), Catch::Contains("4 costs for 0 errors"));
}

TEST_CASE("a drawn chart is a PNG and an SVG, and nothing else is left") {
    const Folder folder;
    const bool drawn = draw(chart_of(curve("sine", {0, 1, 2}, {0, 1, not_a_number})), folder.path / "new" / "run.1");
    if (!drawn) WARN("gnuplot is not installed: nothing was drawn");
    if (!drawn) return;
    CHECK(content(folder.path / "new" / "run.1.png").starts_with("\x89PNG\r\n\x1a\n"));
    const std::string svg = content(folder.path / "new" / "run.1.svg");
    CHECK(svg.starts_with("<?xml"));
    CHECK(svg.find("</svg>") != std::string::npos);
    CHECK(std::distance(fs::directory_iterator(folder.path / "new"), {}) == 2);
}

TEST_CASE("texts appear verbatim, whatever they mean to gnuplot, to a shell or to XML") {
    const std::string text = R"(it's "q_0" \n C:\x ^2 {a} @b $c %g `echo no` ∂p/∂t λ)";
    Chart chart = chart_of(curve(text + " in the legend", {0, 1}, {0, 1}));
    chart.title = text + " in the title";
    chart.panels[0].title = text + " over the panel";
    chart.panels[0].x.label = text + " along x";
    chart.panels[0].y.label = text + " along y";
    chart.panels[0].curves[0].point_labels = {"", text + " at a point"};
    const std::string svg = svg_of(chart);
    if (svg.empty()) return;
    for (const char* place : {"in the legend", "in the title", "over the panel", "along x", "along y", "at a point"})
        CHECK_THAT(svg, Catch::Contains(text + " " + place + "</text>"));
    CHECK_THAT(svg_of(chart_of(curve("a < b & c", {0, 1}, {0, 1}))), Catch::Contains("a &lt; b &amp; c"));
}

TEST_CASE("a chart without anything that its axes can show is still drawn") {
    for (const bool log : {false, true}) {
        CHECK_NOTHROW(svg_of(chart_of(curve("zeros", {0, 0}, {0, -1}), log)));
        CHECK_NOTHROW(svg_of(chart_of(curve("nothing", {}, {}), log)));
        CHECK_NOTHROW(svg_of(chart_of(curve("not finite", {not_a_number, 1}, {1, infinity}), log)));
        CHECK_NOTHROW(svg_of(chart_of(curve("one value", {1, 1}, {2, 2}), log)));
        CHECK_NOTHROW(svg_of(chart_of(curve("zero among others", {0, 1, 10, 100}, {1, 0, 1e-3, 1e-9}), log)));
    }
}

TEST_CASE("labels of neighbouring points do not cover each other") {
    std::vector<CostPoint> points;
    for (int i = 0; i < 16; ++i)
        points.push_back({"method " + std::to_string(10 + i), "family " + std::to_string(i % 4),
                          std::pow(10, -1 + 0.02 * (i % 4)), std::pow(10, -3 + 0.02 * (i / 4.0))});
    points.push_back({"far", "family 0", 10, 1e-5});
    const std::string svg = svg_of(speed_accuracy_chart("close points", points, "CPU time [s]", "error [1]"));
    if (svg.empty()) return;
    std::vector<std::pair<double, double>> placed;
    for (std::size_t at = 0; (at = svg.find("<text>method", at)) != std::string::npos; ++at) {
        auto& [x, y] = placed.emplace_back();
        std::sscanf(svg.c_str() + svg.rfind("translate(", at), "translate(%lf,%lf)", &x, &y);
    }
    REQUIRE(placed.size() == 16);
    const double width = 90, height = 17;    // of "method 10" at 13 pt [px]
    for (std::size_t i = 0; i < placed.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            CHECK((std::abs(placed[i].first - placed[j].first) >= width ||
                   std::abs(placed[i].second - placed[j].second) >= height));
}

TEST_CASE("a speed and accuracy chart joins the best of each family and rings the front of what its axes can show") {
    const Chart chart = speed_accuracy_chart(
        "t", {{"a", "one", 1, 1e-2}, {"b", "two", 2, 1e-3}, {"c", "one", 3, 1e-2}, {"exact", "two", 4, 0}}, "s", "e");
    const auto& curves = chart.panels.at(0).curves;
    REQUIRE(curves.size() == 7);
    CHECK(curves[0].label == "one");
    CHECK(curves[0].point_labels == std::vector<std::string>{"a"});
    CHECK(curves[1].point_labels == std::vector<std::string>{"c"});
    CHECK(curves[1].family == curves[0].family);
    CHECK(curves[6].label == "Pareto front");
    CHECK(curves[6].x == std::vector<double>{1, 2});
}

TEST_CASE("a speed and accuracy chart has the predicted curve of a family and a line to the cheapest point at each target") {
    const Chart chart = speed_accuracy_chart("t", {{"a", "one", 2, 1e-2, 4, 2e-2}, {"b", "one", 1, 1e-1, 3, 3e-1}, {"c", "one", 5, 1e-4}}, "s", "e",
                                             {{5e-2, "5 %"}, {1e-5, "none meets it"}, {1, "all meet it"}});
    const auto& curves = chart.panels.at(0).curves;
    REQUIRE(curves.size() == 6);
    CHECK(curves[2].x == std::vector<double>{3, 4});
    CHECK(curves[2].y == std::vector<double>{3e-1, 2e-2});
    CHECK(curves[4].label == "dashed: predicted");
    CHECK(curves[5].point_labels.at(0) == "5 %");
    CHECK(curves[5].x == std::vector<double>{1, 2});
}

TEST_CASE("a crowded speed and accuracy chart labels the best points only") {
    std::vector<CostPoint> points;
    for (int i = 0; i < 40; ++i) points.push_back({"p" + std::to_string(i), i % 2 ? "odd" : "even", 1.0 + i, i < 4 ? 1.0 / (1 + i) : 2.0});
    std::vector<std::string> labels;
    const Chart chart = speed_accuracy_chart("t", points, "s", "e");
    for (const Curve& curve : chart.panels.at(0).curves)
        for (const std::string& label : curve.point_labels)
            if (!label.empty()) labels.push_back(label);
    CHECK(labels == std::vector<std::string>{"p0", "p2", "p1", "p3"});
}

TEST_CASE("without gnuplot a script with its data inside is left") {
    const Folder folder;
    const SearchPath nowhere(folder.path);
    CHECK_FALSE(draw(chart_of(curve("sine", {0, 1}, {0.25, 0.75})), folder.path / "chart"));
    const std::string script = content(folder.path / "chart.gp");
    CHECK(script.find("1 0.75\n") != std::string::npos);
    CHECK(script.find("set output 'chart.png'") != std::string::npos);
    CHECK_FALSE(fs::exists(folder.path / "chart.png"));
}

TEST_CASE("a gnuplot that fails is reported with its words and its script is kept") {
    const Folder folder;
    std::ofstream(folder.path / "gnuplot") << "#!/bin/sh\necho unknown terminal >&2\nexit 1\n";
    fs::permissions(folder.path / "gnuplot", fs::perms::owner_all);
    const SearchPath broken(folder.path);
    const Chart chart = chart_of(curve("sine", {0, 1}, {0, 1}));
    CHECK_THROWS_WITH(draw(chart, folder.path / "chart"), Catch::Contains("unknown terminal"));
    CHECK(fs::exists(folder.path / "chart.gp"));
    CHECK_FALSE(fs::exists(folder.path / "chart.svg"));
}

TEST_CASE("a chart that cannot be meant is refused with the place and the values") {
    Chart chart = chart_of(curve("sine", {0, 1}, {0}));
    CHECK_THROWS_WITH(draw(chart, "unused"), Catch::Contains("curve \"sine\"") && Catch::Contains("2 x for 1 y"));
    chart = chart_of(curve("sine", {1, 2}, {1, 2}), true);
    chart.panels[0].x.lower = 0;
    CHECK_THROWS_WITH(draw(chart, "unused"), Catch::Contains("\"x [m]\"") && Catch::Contains("positive"));
    chart.panels[0].x.lower = 3, chart.panels[0].x.upper = 2;
    CHECK_THROWS_WITH(draw(chart, "unused"), Catch::Contains("not below"));
    CHECK_THROWS_AS(draw(Chart{}, "unused"), Error);
}
