/// The reference duct_mode: modes between side walls.
#include "reference_fields.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

const abi::Medium medium{2, 1.5};
constexpr double amplitude = 3;

struct Duct {
    int d = 2, axis = 0;
    const char* walls = "rigid";
    double wave_number = 2.3;
    std::vector<double> mode{1, 2}, lower{-0.2, 0.3}, upper{0.9, 1.1};    // of the d - 1 axes across the duct
};

Given given(const Duct& duct) {
    constexpr const char* axes[] = {"x", "y", "z"};
    const auto corner = [&](std::vector<double> of_walls, double along) {
        of_walls.insert(of_walls.begin() + duct.axis, along);
        return vector_of(duct.d, of_walls.data());
    };
    return {{"amplitude", real_of(amplitude)}, {"axis", text_of(axes[duct.axis])}, {"walls", text_of(duct.walls)},
            {"wave_number", real_of(duct.wave_number)}, {"mode", corner(duct.mode, 0)},
            {"lower", corner(duct.lower, 5)}, {"upper", corner(duct.upper, -5)}};
}

std::unique_ptr<abi::Reference> prepared(int d, const std::string& name, const Given& values) {
    auto reference = reference_with(name, values);
    reference->prepare({.dimension = d, .medium = medium});
    return reference;
}
std::unique_ptr<abi::Reference> prepared(const Duct& duct) { return prepared(duct.d, "duct_mode", given(duct)); }

/// The axes across the duct.
std::vector<int> across(const Duct& duct) {
    std::vector<int> axes;
    for (int a = 0; a < duct.d; ++a)
        if (a != duct.axis) axes.push_back(a);
    return axes;
}

/// Of the mode's crests: omega/kx with omega = c0 |k|.
double phase_speed(const Duct& duct) {
    double squares = duct.wave_number * duct.wave_number;
    for (std::size_t row = 0; row + 1 < std::size_t(duct.d); ++row)
        squares += std::pow(duct.mode[row] * pi / (duct.upper[row] - duct.lower[row]), 2);
    return medium.c0 * std::sqrt(squares) / duct.wave_number;
}

/// In 2-D and 3-D, along each axis, between either kind of walls.
template <class Law>
void for_ducts(Law law) {
    for (int d = 2; d <= 3; ++d)
        for (int axis = 0; axis < d; ++axis)
            for (const char* walls : {"rigid", "soft"})
                for (const double wave_number : {2.3, -0.9}) {
                    INFO(walls << " duct in " << d << "-D along axis " << axis << ", kx = " << wave_number << "/m");
                    law(Duct{.d = d, .axis = axis, .walls = walls, .wave_number = wave_number});
                }
}

}    // namespace

TEST_CASE("a duct's mode solves linear acoustics", "[reference]") {
    for_ducts([](const Duct& duct) {
        const auto reference = prepared(duct);
        for (const double t : {-0.15, 0.37}) {
            const double x[3] = {0.17, 0.46, 0.59};
            REQUIRE(std::abs(at(*reference, duct.d, t, x).p) > 0.05);
            check_acoustics(*reference, medium, duct.d, t, x);
        }
    });
}

TEST_CASE("no velocity crosses a duct's rigid walls, and there is no pressure on soft ones", "[reference]") {
    for_ducts([](const Duct& duct) {
        const auto reference = prepared(duct);
        const bool rigid = std::string(duct.walls) == "rigid";
        const auto axes = across(duct);
        for (std::size_t row = 0; row < axes.size(); ++row)
            for (const double wall : {duct.lower[row], duct.upper[row]}) {
                double x[3] = {0.17, 0.46, 0.59};
                x[axes[row]] = wall;
                const Field f = at(*reference, duct.d, 0.1, x);
                const double kept = medium.rho0 * medium.c0 * f.u[axes[row]];    // [Pa]
                CHECK(std::abs(rigid ? kept : f.p) < 1e-13 * amplitude);
                CHECK(std::abs(rigid ? f.p : kept) > 0.03 * amplitude);
            }
    });
}

TEST_CASE("a duct's crests run faster than sound, and its energy slower by as much", "[reference]") {
    for_ducts([](const Duct& duct) {
        const auto reference = prepared(duct);
        const double speed = phase_speed(duct), period = 2 * pi / std::abs(duct.wave_number * speed);
        CHECK(std::abs(speed) > 1.2 * medium.c0);
        double x[3] = {0.17, 0.46, 0.59}, ahead[3] = {0.17, 0.46, 0.59};
        ahead[duct.axis] += 0.8 * speed;
        CHECK(at(*reference, duct.d, 0.9, ahead).p == Approx(at(*reference, duct.d, 0.1, x).p).epsilon(1e-12));

        double flux = 0, energy = 0, loudest = 0;    // over a period and a cross-section: means of n equidistant values are exact
        const int n = 12;
        const auto axes = across(duct);
        for (int step = 0; step < n; ++step)
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < (duct.d == 3 ? n : 1); ++j) {
                    for (std::size_t row = 0; row < axes.size(); ++row)
                        x[axes[row]] = duct.lower[row] + ((row ? j : i) + 0.5) / n * (duct.upper[row] - duct.lower[row]);
                    const Field f = at(*reference, duct.d, step * period / n, x);
                    flux += f.p * f.u[duct.axis];
                    energy += 0.5 * f.p * f.p / (medium.rho0 * medium.c0 * medium.c0);
                    for (const double u : f.u) energy += 0.5 * medium.rho0 * u * u;
                    loudest = std::max(loudest, std::abs(f.p));
                }
        CHECK(flux / energy == Approx(medium.c0 * medium.c0 / speed).epsilon(1e-12));
        CHECK(loudest <= amplitude);
        CHECK(loudest > 0.8 * amplitude);
    });
}

TEST_CASE("a rigid duct's plane mode is a plane wave", "[reference]") {
    for (int d = 2; d <= 3; ++d) {
        const auto mode = prepared({.d = d, .axis = 1, .mode = {0, 0}});
        const std::vector<double> k{0, 2.3, 0};
        const auto wave = prepared(d, "travelling_wave", {{"amplitude", real_of(amplitude)}, {"phase", real_of(pi / 2)}, {"wave_number", vector_of(d, k.data())}});
        const double x[3] = {0.17, 0.46, 0.59};
        const Field expected = at(*wave, d, 0.3, x), found = at(*mode, d, 0.3, x);
        CHECK(std::abs(found.p - expected.p) < 1e-13);
        for (int a = 0; a < d; ++a) CHECK(std::abs(found.u[a] - expected.u[a]) < 1e-13);
    }
}

TEST_CASE("a rigid duct's modes that run forwards and backwards make a box's standing wave", "[reference]") {
    for (const double wave_number : {2.3, 0.0}) {    // at the cut-off each of the two stands already
        const Duct duct{.d = 3, .axis = 2, .wave_number = wave_number, .lower = {0, 0}};
        Duct backwards = duct;
        backwards.wave_number = -wave_number;
        const auto right = prepared(duct), left = prepared(backwards);
        const std::vector<double> k{pi / 0.9, 2 * pi / 1.1, wave_number};
        const auto box = prepared(3, "standing_wave", {{"amplitude", real_of(2 * amplitude)}, {"wave_number", vector_of(k)}});
        const double omega = medium.c0 * std::hypot(k[0], k[1], k[2]), x[3] = {0.17, 0.46, 0.59};
        for (const double t : {0.0, 0.1, 0.23}) {    // a cosine is a sine a quarter of a period later
            const double later = t + pi / 2 / omega;
            const Field r = at(*right, 3, later, x), l = at(*left, 3, later, x), whole = at(*box, 3, t, x);
            CHECK(std::abs(r.p + l.p - whole.p) < 1e-12);
            for (int a = 0; a < 3; ++a) CHECK(std::abs(r.u[a] + l.u[a] - whole.u[a]) < 1e-12);
        }
    }
}

TEST_CASE("a duct's mode that cannot be is refused", "[reference]") {
    const auto refused = [](const Duct& duct, const char* why) { CHECK_THROWS_WITH(prepared(duct), why); };
    CHECK_THROWS_WITH(prepared(2, "duct_mode", given({.d = 3, .axis = 2})), "there is no axis z in this dimension: choose another");
    refused({.mode = {0.5}}, "mode counts half waves across the duct: give whole numbers");
    refused({.walls = "soft", .mode = {0}}, "between soft walls mode 0 is silence: give 1 or more");
    refused({.wave_number = 0, .mode = {0}}, "nothing moves: give a wave_number, or a mode, other than zero");
    refused({.lower = {0.9}}, "upper does not lie above lower: give the walls in order");
    for (const char* name : {"mode", "lower", "upper"}) {
        Given values = given(Duct{});
        values[name] = vector_of({0});
        CHECK_THROWS_WITH(prepared(2, "duct_mode", values), std::string(name) + " needs one component per dimension");
    }
    Given oblique = given(Duct{});
    oblique["mode"] = vector_of({1, 1});
    CHECK_THROWS_WITH(prepared(2, "duct_mode", oblique), "mode counts half waves across the duct: give 0 along x");
    CHECK_THROWS_WITH(prepared(1, "duct_mode", given(Duct{})), "a duct has side walls: it needs two or three dimensions");
}
