/// References are solutions of linear acoustics, with the u that belongs to their p.
#include "quadrature.hpp"
#include "reference_fields.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

const abi::Medium medium{2, 1.5};
constexpr double amplitude = 3, width = 0.5, centre[3] = {0.1, -0.2, 0.3}, wall_at = 0.7;

/// What a wave is before: a wall normal to `axis` at `wall_at`.
struct WallOf {
    const char* type = "rigid";
    int axis = 0;
};

/// Not prepared; vectors have d components.
std::unique_ptr<abi::Reference> created(const std::string& name, int d, const WallOf& wall = {}, const std::vector<double>& k = {2.1, -1.3, 0.7}) {
    constexpr const char* axes[] = {"x", "y", "z"};
    const Given all{{"amplitude", real_of(amplitude)}, {"phase", real_of(0.4)}, {"width", real_of(width)}, {"position", real_of(wall_at)},
                    {"wall", text_of(wall.type)}, {"axis", text_of(axes[wall.axis])},
                    {"wave_number", vector_of(d, k.data())}, {"centre", vector_of(d, centre)}};
    Given given;
    for (const auto& row : registry().find("reference", name, "contract").parameters)
        if (all.count(row.name)) given.insert(*all.find(row.name));
    return reference_with(name, given);
}

std::unique_ptr<abi::Reference> walled(const char* wall, int d, int axis, const std::vector<double>& k = {2.1, -1.3, 0.7}) {
    return created("reflected_wave", d, {wall, axis}, k);
}

std::unique_ptr<abi::Reference> prepared(const std::string& name, int d) {
    auto reference = created(name, d);
    reference->prepare({.dimension = d, .medium = medium});
    return reference;
}

/// p and the radial u of the pulse at distances r from its centre, along the first axis, in one call.
struct Radial {
    std::vector<double> p, u;
};

Radial radial(const abi::Reference& pulse, int d, double t, const std::vector<double>& r) {
    std::vector<double> x(r), y(r.size(), centre[1]), z(r.size(), centre[2]), across(r.size(), untouched);
    for (double& value : x) value += centre[0];
    Radial f{std::vector<double>(r.size()), std::vector<double>(r.size())};
    pulse.evaluate(t, {.dimension = d, .n = int(r.size()), .x = {x.data(), d > 1 ? y.data() : nullptr, d > 2 ? z.data() : nullptr}},
                   {.p = f.p.data(), .u = {f.u.data(), d > 1 ? across.data() : nullptr, nullptr}});
    CHECK(largest(across) == (d > 1 ? 0 : untouched));
    return f;
}

/// Poisson's formula for the plane at (r, 0): with m(s) the mean over the circle of radius s about that point,
///   p = int_0^(pi/2) (m + s dm/ds)[p0] sin(a) da,   u = -t/rho0 int_0^(pi/2) m[grad p0] sin(a) da,   s = c0 t sin(a).
Field poisson(double r, double t) {
    const double pi = std::numbers::pi, tau = medium.c0 * t;
    const int turns = 64 + int(12 * (r + tau) / width);    // points of a circle: its mean converges faster than any power
    const auto integrand = [&](double angle, bool velocity) {
        const double s = tau * std::sin(angle);
        double sum = 0;
        for (int j = 0; j < turns; ++j) {
            const double cosine = std::cos(2 * pi * j / turns), sine = std::sin(2 * pi * j / turns);
            const double x = r + s * cosine, y = s * sine, p0 = amplitude * std::exp(-(x * x + y * y) / (width * width));
            const double slope = -2 / (width * width) * p0;    // grad p0 = slope (x, y)
            sum += velocity ? -t / medium.rho0 * slope * x : p0 + s * slope * (x * cosine + y * sine);
        }
        return sum / turns * std::sin(angle);
    };
    const auto whole = [&](bool velocity) {
        return integral(pi / 2, pi / 2, 32, [&](std::vector<double> angle) {
            for (double& value : angle) value = integrand(value, velocity);
            return angle;
        });
    };
    return {whole(false), {whole(true), 0, 0}};
}

}    // namespace

TEST_CASE("waves and the pulse solve linear acoustics in each dimension", "[reference]") {
    for (const char* name : {"travelling_wave", "standing_wave", "pulse"})
        for (int d = 1; d <= 3; ++d) {
            const auto reference = prepared(name, d);
            for (const double distance : {0.002, 0.1, 0.2, 1.0}) {
                INFO(name << " in " << d << "-D, " << distance << " m from the pulse's centre");
                double x[3];
                const double towards[3] = {0.36, -0.48, 0.8};
                for (int a = 0; a < 3; ++a) x[a] = centre[a] + distance * towards[a];
                REQUIRE(std::abs(at(*reference, d, 0.2, x).p) > 0.05);
                check_acoustics(*reference, medium, d, 0.2, x);
            }
        }
}

TEST_CASE("a reflected wave solves linear acoustics and keeps the wall's condition, in each dimension along each axis", "[reference]") {
    for (const std::string wall : {"rigid", "soft", "absorbing"})
        for (int d = 1; d <= 3; ++d)
            for (int axis = 0; axis < d; ++axis) {
                INFO(wall << " wall in " << d << "-D, normal to axis " << axis);
                const auto reference = walled(wall.c_str(), d, axis), incident = prepared("travelling_wave", d);
                reference->prepare({.dimension = d, .medium = medium});
                for (const double t : {0.2, 0.9}) {
                    double x[3] = {0.17, 0.42, -0.61};
                    const Field wave = at(*incident, d, t, x), before_wall = at(*reference, d, t, x);
                    check_acoustics(*reference, medium, d, t, x);
                    // the way it comes is the travelling wave; what is added to it is as large as the wall sends back
                    CHECK((before_wall.p == Approx(wave.p).epsilon(1e-12)) == (wall == "absorbing"));
                    x[axis] = wall_at;
                    const Field coming = at(*incident, d, t, x), on_wall = at(*reference, d, t, x);
                    const double p_kept = wall == "rigid" ? 2 : wall == "soft" ? 0 : 1;
                    CHECK(std::abs(on_wall.p - p_kept * coming.p) < 1e-12 * amplitude);
                    for (int a = 0; a < d; ++a)
                        CHECK(std::abs(on_wall.u[a] - (a == axis ? 2 - p_kept : p_kept) * coming.u[a]) < 1e-12 * amplitude);
                    REQUIRE(std::abs(coming.p) > 0.02 * amplitude);    // or these say nothing
                }
            }
}

TEST_CASE("a reflected wave needs an axis of the space and a wave that meets the wall", "[reference]") {
    CHECK_THROWS_WITH(walled("rigid", 2, 2)->prepare({.dimension = 2, .medium = medium}), "there is no axis z in this dimension: choose another");
    CHECK_THROWS_WITH(walled("rigid", 2, 1, {2, 0, 0})->prepare({.dimension = 2, .medium = medium}),
                      "wave_number has no component along y: the wave never meets the wall");
    CHECK_THROWS_WITH(walled("rigid", 3, 0)->prepare({.dimension = 2, .medium = medium}), "wave_number needs one component per dimension");
}

TEST_CASE("a reference whose vector does not fit the dimension is refused", "[reference]") {
    for (const char* name : {"travelling_wave", "standing_wave"})
        CHECK_THROWS_WITH(created(name, 3)->prepare({.dimension = 2, .medium = medium}), "wave_number needs one component per dimension");
    CHECK_THROWS_WITH(created("pulse", 3)->prepare({.dimension = 2, .medium = medium}),
                      "centre needs one component per dimension, or leave it out for the origin");
}

TEST_CASE("the pulse starts from a Gaussian at rest, a mirror in time", "[reference]") {
    const std::vector<double> r{0, 1e-9, 0.3, 1.1, 2.4};
    for (int d = 1; d <= 3; ++d) {
        INFO(d << "-D");
        const Radial start = radial(*prepared("pulse", d), d, 0, r);
        for (std::size_t i = 0; i < r.size(); ++i)
            CHECK(std::abs(start.p[i] - amplitude * std::exp(-r[i] * r[i] / (width * width))) < 1e-11 * amplitude);
        CHECK(largest(start.u) < 1e-11);
        const Radial before = radial(*prepared("pulse", d), d, -0.1, r);
        Radial after = radial(*prepared("pulse", d), d, 0.1, r);
        for (double& u : after.u) u = -u;
        CHECK(gap(before.p, after.p) == 0);
        CHECK(gap(before.u, after.u) == 0);
    }
}

TEST_CASE("about its centre the pulse flows as its pressure falls", "[reference]") {
    // u = -r dp/dt / (d rho0 c0^2) as r -> 0, where the closed forms divide by r
    const double t = 0.2, e = 1e-4;
    for (int d = 1; d <= 3; ++d) {
        const auto pulse = prepared("pulse", d);
        const double fall = radial(*pulse, d, t - e, {0}).p[0] - radial(*pulse, d, t + e, {0}).p[0];
        CHECK(radial(*pulse, d, t, {0}).u[0] == 0);
        for (const double r : {1e-4, 1e-7, 1e-10}) {
            INFO(d << "-D at r = " << r << " m");
            const double x = centre[0] + r;    // rounded
            const double slope = fall / (2 * e) / (d * medium.rho0 * medium.c0 * medium.c0);
            CHECK(radial(*pulse, d, t, {r}).u[0] == Approx(slope * (x - centre[0])).epsilon(1e-6));
            CHECK(radial(*pulse, d, t, {r}).p[0] == Approx(radial(*pulse, d, t, {0}).p[0]).epsilon(1e-6));
        }
    }
}

TEST_CASE("the pulse keeps the integral of its pressure and its energy", "[reference]") {
    const double half_pi = std::numbers::pi / 2, compliance = 1 / (medium.rho0 * medium.c0 * medium.c0);
    for (int d = 1; d <= 3; ++d)
        for (const double t : {0.0, 0.1, 1.0}) {
            INFO(d << "-D at t = " << t << " s");
            const auto pulse = prepared("pulse", d);
            const double length = medium.c0 * t + 6 * width;
            const auto over_space = [&](auto&& density) {
                return integral(length, width, 1, [&](const std::vector<double>& r) {
                    const Radial f = radial(*pulse, d, t, r);
                    std::vector<double> y(r.size());
                    for (std::size_t i = 0; i < r.size(); ++i) y[i] = shell(d, r[i]) * density(f.p[i], f.u[i]);
                    return y;
                });
            };
            const double volume = std::pow(width * std::sqrt(half_pi), d);    // of exp(-2 (r/width)^2)
            CHECK(over_space([](double p, double) { return p; }) == Approx(amplitude * std::pow(2, d / 2.0) * volume).epsilon(1e-9));
            CHECK(over_space([&](double p, double u) { return 0.5 * (compliance * p * p + medium.rho0 * u * u); }) ==
                  Approx(0.5 * compliance * amplitude * amplitude * volume).epsilon(1e-9));
        }
}

TEST_CASE("the circular pulse is the one of Poisson's formula", "[reference]") {
    const auto pulse = prepared("pulse", 2);
    const double impedance = medium.rho0 * medium.c0;
    for (const double tau : {0.0, 0.4, 1.0, 2.5, 8.0, 30.0})    // c0 t / width
        for (const double r : {0.0, 0.01, 0.7, tau - 0.8, tau, tau + 1.5, tau + 5.9, tau + 6.1}) {
            if (r < 0) continue;
            INFO("r = " << r << " widths, c0 t = " << tau << " widths");
            const double t = tau * width / medium.c0;
            const Field expected = poisson(r * width, t);
            const Radial found = radial(*pulse, 2, t, {r * width});
            CHECK(std::abs(found.p[0] - expected.p) < 1e-11 * amplitude);
            CHECK(impedance * std::abs(found.u[0] - expected.u[0]) < 1e-11 * amplitude);
        }
}
