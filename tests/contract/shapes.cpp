/// Laws of every shape found, and of some by name.
#include <random>

#include <sphonic/error.hpp>
#include <sphonic/read_formula.hpp>

#include "subjects.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

constexpr double dx = 0.1, half = 2;

abi::ShapeScene scene_of(int dimension) {
    abi::ShapeScene scene{.box = {.dimension = dimension, .dx = dx}};
    for (int a = 0; a < dimension; ++a) scene.box.lower[a] = -half, scene.box.upper[a] = half;
    static const int dimensions[] = {0, 1, 2, 3};
    scene.formula = [](const void* host, const char* text) -> std::unique_ptr<abi::Formula> {
        return std::make_unique<ReadFormula>(Expression(text, {}, *static_cast<const int*>(host), "contract"));
    };
    scene.host = &dimensions[dimension];
    return scene;
}

struct Measured {
    double distance, normal[3];
};
using Place = std::array<double, 3>;

Measured measured(const abi::Shape& shape, int dimension, const Place& x) {
    abi::Points point{.dimension = dimension, .n = 1};
    Measured m{untouched, {0, 0, 0}};
    double* normal[3] = {};
    for (int a = 0; a < dimension; ++a) {
        point.x[a] = &x[std::size_t(a)];
        normal[a] = &m.normal[a];
    }
    shape.measure(point, &m.distance, normal);
    return m;
}

Place moved(const Place& x, const Measured& m, double by) {
    return {x[0] + by * m.normal[0], x[1] + by * m.normal[1], x[2] + by * m.normal[2]};
}

/// The laws, for a shape that has taken a box.
void obeys_the_laws(const abi::Shape& shape, int dimension) {
    std::mt19937 bits(1);
    const auto random = [&] { return half * (2 * double(bits()) * 0x1p-32 - 1); };
    double off_unit = 0, off_surface = 0, stretch = 0, off_line = 0;
    for (int k = 0; k < 300; ++k) {
        const Place x{random(), dimension > 1 ? random() : 0, dimension > 2 ? random() : 0};
        const Place y{random(), dimension > 1 ? random() : 0, dimension > 2 ? random() : 0};
        const Measured m = measured(shape, dimension, x);
        const double side = m.distance < 0 ? -1 : 1;
        off_unit = std::max(off_unit, std::abs(std::hypot(m.normal[0], m.normal[1], m.normal[2]) - 1));
        off_surface = std::max(off_surface, std::abs(measured(shape, dimension, moved(x, m, -m.distance)).distance));
        const double between = std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
        stretch = std::max(stretch, std::abs(m.distance - measured(shape, dimension, y).distance) - between);
        const double half_way = measured(shape, dimension, moved(x, m, -0.5 * m.distance)).distance;
        off_line = std::max(off_line, std::abs(half_way - 0.5 * side * std::abs(m.distance)));
    }
    CHECK(off_unit < 1e-12);
    CHECK(off_surface < 1e-6 * dx);    // the nearest point is on it
    CHECK(stretch < 1e-6 * dx);        // distances grow no faster than one moves
    CHECK(off_line < 1e-6 * dx);       // towards the nearest point, as fast
}

std::unique_ptr<abi::Shape> text_shape(const std::string& name, const std::string& text) {
    return registry().create<abi::Shape>(registry().find("shape", name, "contract"), {{.type = abi::ParameterType::text, .text = text.c_str()}});
}

std::string refusal(abi::Shape& shape, int dimension) {
    try {
        shape.prepare(scene_of(dimension));
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "nothing was refused";
}

}    // namespace

TEST_CASE("a shape measures distance and normal from its surface, or says why not in this scene", "[shape]") {
    int taken = 0;
    for (const int d : {1, 2, 3})
        for (const auto& subject : subjects<abi::Shape>()) {    // anew for each scene: it is prepared once
            INFO(subject.label << " in " << d << "-D");
            const std::string said = refusal(*subject.object, d);
            CHECK(said.size() > 18);
            if (said != "nothing was refused") continue;
            ++taken;
            obeys_the_laws(*subject.object, d);
        }
    CHECK(taken > 0);
}

TEST_CASE("a polygon measures from its edges and corners, whichever way round they are given", "[shape]") {
    for (const char* corners : {"0 0, 1 0, 1 0.5, 0 0.5", "0 0.5,1 0.5,1 0,0 0"}) {
        const auto box = text_shape("polygon", corners);
        REQUIRE(refusal(*box, 2) == "nothing was refused");
        obeys_the_laws(*box, 2);
        const auto is = [&](double x, double y, double distance, double nx, double ny) {
            const Measured m = measured(*box, 2, {x, y, 0});
            INFO(x << ", " << y);
            CHECK(m.distance == Approx(distance).margin(1e-14));
            CHECK(m.normal[0] == Approx(nx).margin(1e-14));
            CHECK(m.normal[1] == Approx(ny).margin(1e-14));
        };
        is(0.5, 0.7, 0.2, 0, 1);
        is(0.5, 0.4, -0.1, 0, 1);
        is(0.95, 0.25, -0.05, 1, 0);
        is(1.3, 0.9, 0.5, 0.6, 0.8);
        is(0.4, 0, 0, 0, -1);
    }
    const auto star = text_shape("polygon", "1.5 0, 0.4 0.3, 0 1.5, -0.4 0.3, -1.5 0, -0.3 -0.4, 0 -1.5, 0.3 -0.4");
    REQUIRE(refusal(*star, 2) == "nothing was refused");
    obeys_the_laws(*star, 2);
}

TEST_CASE("a shape by expression measures true distances, whatever the slope of the expression", "[shape]") {
    const auto ellipse = text_shape("expression", "5*(x^2/2.25 + y^2/0.64 - 1)");
    REQUIRE(refusal(*ellipse, 2) == "nothing was refused");
    const Measured end = measured(*ellipse, 2, {1.9, 0, 0}), top = measured(*ellipse, 2, {0, 1.1, 0});
    CHECK(end.distance == Approx(0.4).epsilon(1e-7));
    CHECK(end.normal[0] == Approx(1).epsilon(1e-9));
    CHECK(top.distance == Approx(0.3).epsilon(1e-7));
    for (const double angle : {0.3, 0.9, 1.4}) {    // off the surface along its normal
        const double c = 1.5 * std::cos(angle), s = 0.8 * std::sin(angle), nx = c / 2.25, ny = s / 0.64, length = std::hypot(nx, ny);
        for (const double out : {-0.15, 0.5}) {
            const Measured m = measured(*ellipse, 2, {c + out * nx / length, s + out * ny / length, 0});
            CHECK(m.distance == Approx(out).epsilon(1e-6));
            CHECK(m.normal[0] == Approx(nx / length).epsilon(1e-5));
        }
    }
    for (const int d : {1, 2, 3}) {
        const auto ball = text_shape("expression", "r - 1.2"), plane = text_shape("expression", "2*(x - 0.3)");
        for (abi::Shape* shape : {ball.get(), plane.get()}) {
            REQUIRE(refusal(*shape, d) == "nothing was refused");
            obeys_the_laws(*shape, d);
        }
    }
}

TEST_CASE("a shape by expression knows how deep the very middle of a thin body is, where its slope vanishes", "[shape]") {
    for (const char* surface : {"x^2 - 0.01", "abs(x) - 0.1", "(x - 0.1)*(x + 0.1)"})
        for (const int d : {1, 2, 3}) {
            const auto plate = text_shape("expression", surface);
            REQUIRE(refusal(*plate, d) == "nothing was refused");
            INFO(surface << " in " << d << "-D");
            for (const double x : {0.0, 0.03, -0.08}) {
                const Measured m = measured(*plate, d, {x, d > 1 ? 0.7 : 0, d > 2 ? -0.4 : 0});
                CHECK(m.distance == Approx(std::abs(x) - 0.1).epsilon(1e-6));
                CHECK(std::abs(m.normal[0]) == Approx(1).epsilon(1e-6));
            }
        }
}

TEST_CASE("a shape that cannot be is refused with what to do", "[shape]") {
    const auto polygon = [](const std::string& corners, int d = 2) { return refusal(*text_shape("polygon", corners), d); };
    CHECK(refusal(*make<abi::Shape>("circle"), 1) == "a circle needs two or three dimensions: in one, close the box by boundaries");
    CHECK(polygon("0 0, 1 0, 0 1", 3) == "a polygon needs two dimensions: use another shape");
    CHECK(polygon("") == "corners holds 0 of them: give three or more, such as \"0 0, 2 0, 2 1\"");
    CHECK(polygon("0 0, 1 0") == "corners holds 2 of them: give three or more, such as \"0 0, 2 0, 2 1\"");
    CHECK(polygon("0 0, 1, 0 1") == "corners: \" 1\" is no corner: give x and y, and commas between corners");
    CHECK(polygon("0 0, 1 2 3, 0 1") == "corners: \" 1 2 3\" is no corner: give x and y, and commas between corners");
    CHECK(polygon("0 0, 1 a, 0 1") == "corners: \"a\" is not a finite number: give coordinates in metres");
    CHECK(polygon("0 0, 1 nan, 0 1") == "corners: \"nan\" is not a finite number: give coordinates in metres");
    CHECK(polygon("0 0, 1 0, 1 0, 0 1") == "corners: corner 2 is followed by itself: leave one of them out");
    CHECK(polygon("0 0, 1 0, 0 1, 1 1") == "corners: the edges from corner 2 and from corner 4 cross: give the corners in order around the polygon");
    CHECK(polygon("0 0, 3 0, 3 1, 1 0, 0 1") == "corners: the edges from corner 1 and from corner 3 cross: give the corners in order around the polygon");
    CHECK(refusal(*text_shape("expression", ""), 2) == "surface is missing: give an expression that is zero on it and positive outside the body");
    CHECK_THROWS_WITH(refusal(*text_shape("expression", "x +"), 2), Catch::Contains("contract: "));
    const auto pole = text_shape("expression", "1/0*x");
    CHECK(refusal(*pole, 2) == "nothing was refused");
    CHECK_THROWS_WITH(measured(*pole, 2, {0.5, 0.5, 0}), "surface: \"1/0*x\" is not finite in the whole box: choose an expression that is");
}
