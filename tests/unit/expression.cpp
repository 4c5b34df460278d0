#include <sphonic/error.hpp>
#include <sphonic/expression.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

using namespace sphonic;

namespace {

const std::string place = "case.json: /f";
const Expression::Constants constants{{{"c0", 340.5}, {"alpha", -0.25}, {"ln", 3}}};

struct Valued { std::string text; double value; };
struct Member { std::string text; bool inside; };
struct Refused { std::string text, message; };

template <class Made>
std::string refusal(const std::string& text, const Expression::Constants& given, int dimension) {
    try {
        Made(text, given, dimension, place);
    } catch (const Error& error) {
        return std::to_string(static_cast<int>(error.fault)) + " " + error.what();
    }
    return "no error";
}

std::string refused(const Refused& row) { return "2 " + place + ": \"" + row.text + "\": " + row.message; }

}    // namespace

TEST_CASE("an expression has the value that mathematics gives it") {
    const double x[] = {2, -3, 0.5};
    const auto [text, value] = GENERATE(values<Valued>({
        {"x + y*z", 0.5}, {"-x^2", -4}, {"2^3^2", 512}, {"2^-1", 0.5}, {"8/4/2", 1}, {"1 - 2 - 3", -4},
        {"-+-x", 2}, {"2--x", 4}, {"(x + y)*z", -0.5}, {".5 + 5. + 1e-1", 5.6}, {"c0*alpha", -85.125},
        {"2^alpha", std::pow(2, -0.25)}, {"ln", 3}, {"pi", std::numbers::pi}, {"r^2", 13.25}, {"log(exp(1))", 1},
        {"sqrt(2)", std::sqrt(2.0)}, {"abs(y)", 3}, {"sin(pi/2) + cos(pi)", 0}, {"tan(pi/4)", 1},
        {"min(x, y, z)", -3}, {"max(1, x)", 2}}));
    const Expression expression(text, constants, 3, place);
    CHECK(expression(x) == Approx(value).margin(1e-15));
    CHECK(expression.text() == text);
}

TEST_CASE("the distance r is that of the coordinates the dimension has") {
    const double x[] = {-3, 4, 12};
    const auto [dimension, distance] = GENERATE(table<int, double>({{1, 3}, {2, 5}, {3, 13}}));
    CHECK(Expression("r", {}, dimension, place)(x) == distance);
}

TEST_CASE("a literal and a constant are the same double that C++ reads") {
    const double value = GENERATE(0.1, 1e23, 340.29, 5e-324, std::numeric_limits<double>::max(), -1.0 / 3);
    const double x = 0;
    CHECK(Expression("h", {{{"h", value}}}, 1, place)(&x) == value);
    CHECK(Expression("1e23 + 0*x", {}, 1, place)(&x) == 1e23);
}

TEST_CASE("a moved expression keeps its value and follows the point") {
    Expression first("2*x", {}, 1, place);
    Expression second("x", {}, 1, place);
    second = std::move(first);
    const Expression third = std::move(second);
    const double near = 1, far = 10;
    CHECK(third(&near) == 2);
    CHECK(third(&far) == 20);
}

TEST_CASE("a region holds the points that meet its condition") {
    const double x[] = {2, -3, 0.5};
    const auto [text, inside] = GENERATE(values<Member>({
        {"0 <= x <= 90", true}, {"0 <= x <= 1", false}, {"3 <= x <= 90", false}, {"0 < x < 2", false},
        {"0 < x <= 2", true}, {"90 >= x > 1 > 0", true}, {"90 >= x > 1 > 1", false}, {"x == 2 == 2", true},
        {"x != 2", false}, {"x == 2", true}, {"x > 1 and y > 0", false}, {"x > 1 or y > 0", true},
        {"x > 1 or y > 0 and z > 9", true}, {"(x > 1 or y > 0) and z > 9", false}, {"not x < 1", true},
        {"not not x < 1", false}, {"not x > 1 or x > 1", true}, {"not (x > 1 or x > 1)", false},
        {"x^2 + y^2 < 14", true}, {"r < 1 + min(x, 1)", false}, {"sqrt(y) < 1", false}, {"c0 > 340", true}}));
    const Region region(text, constants, 3, place);
    CHECK(region.contains(x) == inside);
    CHECK(region.text() == text);
}

TEST_CASE("text that is no expression is refused with its place") {
    const Refused row = GENERATE(values<Refused>({
        {"", "there is no text. Write an expression"},
        {"  ", "there is no text. Write an expression"},
        {"x +", "something is missing at the end. Complete it"},
        {"x * / 2", R"~("/" is out of place at column 5. Correct it there)~"},
        {"x 2", R"~("2" is out of place at column 3. Correct it there)~"},
        {"2pi", R"~("pi" is out of place at column 2. Correct it there)~"},
        {"x)", R"~(")" is out of place at column 2. Correct it there)~"},
        {"(x", R"~(")" is missing at column 3. Add it)~"},
        {"x ? 1", R"~("?" is out of place at column 3. Correct it there)~"},
        {"x ≤ 1", R"~("≤" is out of place at column 3. Correct it there)~"},
        {".", R"~("." is out of place at column 1. Correct it there)~"},
        {"2*not x", R"~("not" is out of place at column 3. Correct it there)~"},
        {"x**2", R"~("**" is not used here. Write ^)~"},
        {"x = 2", R"~("=" is not used here. Write ==)~"},
        {"1e999", "the number 1e999 does not fit a double. Write one that does"},
        {"alhpa", R"~("alhpa" is unknown. Did you mean "alpha"?)~"},
        {"sinn(x)", R"~("sinn" is unknown. Did you mean "sin"?)~"},
        {"q", R"~("q" is unknown. Known are x, r, pi, sin, cos, tan, exp, sqrt, abs, log, min, max, c0, alpha, ln)~"},
        {"_pi", R"~("_pi" is unknown. Did you mean "pi"?)~"},
        {"y", R"~("y" does not exist in 1-D. Use x or r)~"},
        {"sin x", R"~("sin" has no arguments. Write them in parentheses)~"},
        {"x(2)", R"~("x" is not a function. Write * to multiply)~"},
        {"sin()", R"~(")" is out of place at column 5. Correct it there)~"},
        {"sin(1, 2)", "sin is given 2 arguments. Give one"},
        {"min(1)", "min is given 1 argument. Give two or more"},
        {"x < 3", "this is a condition, not a number. Remove the comparison"},
        {"2*(x < 3)", R"~("(x < 3)" is a condition, not a number. Remove the comparison)~"},
        {"sin(x < 3)", R"~("x < 3" is a condition, not a number. Remove the comparison)~"},
    }));
    CHECK(refusal<Expression>(row.text, constants, 1) == refused(row));
}

TEST_CASE("text that is no condition is refused with its place") {
    const Refused row = GENERATE(values<Refused>({
        {"x - 3", "this is a number, not a condition. Compare it with a number"},
        {"not x", R"~("x" is a number, not a condition. Compare it with a number)~"},
        {"x and y > 1", R"~("x" is a number, not a condition. Compare it with a number)~"},
        {"(0 <= x) <= 90", R"~("(0 <= x)" is a condition, not a number. Remove the comparison)~"},
        {"0 < x > 3", R"~("<" and ">" do not chain. Join two comparisons with and)~"},
        {"0 < x == 3", R"~("<" and "==" do not chain. Join two comparisons with and)~"},
        {"0 != x != 3", R"~("!=" and "!=" do not chain. Join two comparisons with and)~"},
        {"x <", "something is missing at the end. Complete it"},
        {"x < y or", "something is missing at the end. Complete it"},
        {"x = 2", R"~("=" is not used here. Write ==)~"},
        {"x => 2", R"~("=>" is not used here. Write >=)~"},
        {"x < 1 && y < 1", R"~("&&" is not used here. Write and)~"},
        {"x < 1 || y < 1", R"~("||" is not used here. Write or)~"},
        {"!(x < 1)", R"~("!" is not used here. Write not)~"},
        {"z < 1", R"~("z" does not exist in 2-D. Use x, y or r)~"},
    }));
    CHECK(refusal<Region>(row.text, constants, 2) == refused(row));
}

TEST_CASE("an expression that nests or grows without end is refused") {
    const Refused nested{std::string(100000, '(') + "x", "more than 64 parts are nested. Nest less deeply"};
    CHECK(refusal<Expression>(nested.text, {}, 1) == refused(nested));
    Refused grown{"x", "muParser says: Expression too long."};
    for (int i = 0; i < 9000; ++i)
        grown.text += "+x";
    CHECK(refusal<Expression>(grown.text, {}, 1) == refused(grown));
}

TEST_CASE("a constant needs a free name and a finite value") {
    const std::string name = GENERATE("x", "z", "r", "pi", "log", "and", "c 0", "2c", "");
    const std::string problem = "\" has a name that is taken or is no name. Rename it";
    CHECK(refusal<Expression>("1", {{{name, 1}}}, 1) == "2 " + place + ": the constant \"" + name + problem);
    CHECK(refusal<Region>("1 < 2", {{{"h", 1}, {"h", 2}}}, 1) == "2 " + place + ": the constant \"h" + problem);
    const double value = GENERATE(std::numeric_limits<double>::infinity(), std::nan(""));
    CHECK(refusal<Expression>("1", {{{"h", value}}}, 1) ==
          "2 " + place + ": the constant \"h\" is not finite. Give it a finite value");
}
