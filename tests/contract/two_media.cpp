/// The reference two_media: a pulse across the interface of two media.
#include <sphonic/media_map.hpp>

#include "quadrature.hpp"
#include "reference_fields.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

constexpr double amplitude = 3, width = 0.5, interface_at = 0.25, crest_at = -3.25;    // [Pa], and [m] along `way`
const abi::Medium first{2, 1.5}, second{3.2, 0.4};
const std::vector<double> way{0.36, -0.48, 0.8};

/// A unit vector of each dimension.
std::vector<double> along(int d) { return d == 1 ? std::vector{1.0} : d == 2 ? std::vector{0.6, 0.8} : way; }

std::vector<double> scaled(std::vector<double> v, double factor) {
    for (double& component : v) component *= factor;
    return v;
}

/// `before` fills space but for what lies beyond the interface across `n`.
MediaMap halves(const std::vector<double>& n, const abi::Medium& before = first, const abi::Medium& beyond = second) {
    std::string region = "0";
    for (std::size_t a = 0; a < n.size(); ++a) region += std::string(" + ") + "xyz"[a] + "*(" + std::to_string(n[a]) + ")";
    MediaMap map(before);
    map.add(beyond, Region(region + " > " + std::to_string(interface_at), {}, int(n.size()), "contract"));
    return map;
}

std::unique_ptr<abi::Reference> prepared(const MediaMap& map, int d, const Given& given) {
    auto reference = reference_with("two_media", given);
    reference->prepare({.dimension = d, .medium = map.list()[0], .media = map.view()});
    return reference;
}

/// Along n, with the interface and the crest where they are said to be.
Given pulse_along(const std::vector<double>& n) {
    return {{"amplitude", real_of(amplitude)}, {"width", real_of(width)}, {"direction", vector_of(scaled(n, 7))},
            {"interface", vector_of(scaled(n, interface_at))}, {"centre", vector_of(scaled(n, crest_at))}};
}

std::unique_ptr<abi::Reference> crossing(int d) { return prepared(halves(along(d)), d, pulse_along(along(d))); }

double gaussian(double x) { return amplitude * std::exp(-x * x / (width * width)); }

/// When the crest reaches the interface.
const double arrival = (interface_at - crest_at) / first.c0;

}    // namespace

TEST_CASE("a pulse before two media starts as a Gaussian that travels", "[reference]") {
    for (int d = 1; d <= 3; ++d) {
        const auto reference = crossing(d);
        for (const double x : {-6.0, -3.7, -3.25, -2.9, -0.1, 0.4}) {
            const auto place = scaled(along(d), x);
            const Field f = at(*reference, d, 0, place.data());
            CHECK(std::abs(f.p - gaussian(x - crest_at)) < 1e-12);
            for (int a = 0; a < d; ++a) CHECK(std::abs(f.u[a] - along(d)[std::size_t(a)] * f.p / (first.rho0 * first.c0)) < 1e-12);
        }
    }
}

TEST_CASE("a pulse in two media solves linear acoustics on either side", "[reference]") {
    for (int d = 1; d <= 3; ++d) {
        const auto reference = crossing(d);
        for (const double lag : {-0.2, 0.05, 0.15})
            for (const double x : {interface_at - 0.3, interface_at - 0.02, interface_at + 0.02, interface_at + 0.3}) {
                INFO(d << "-D, " << x << " m along the way, " << lag << " s after the crest came");
                const auto place = scaled(along(d), x);
                REQUIRE(std::abs(at(*reference, d, arrival + lag, place.data()).p) > 0.05);
                check_acoustics(*reference, x < interface_at ? first : second, d, arrival + lag, place.data());
            }
    }
}

TEST_CASE("pressure and velocity are continuous where two media meet, at all times", "[reference]") {
    for (int d = 1; d <= 3; ++d) {
        const auto reference = crossing(d);
        double loudest = 0;
        for (double t = -1; t < 4; t += 0.0625) {
            const auto before = scaled(along(d), interface_at - 1e-13), beyond = scaled(along(d), interface_at + 1e-13);
            const Field l = at(*reference, d, t, before.data()), r = at(*reference, d, t, beyond.data());
            CHECK(std::abs(l.p - r.p) < 1e-11);
            for (int a = 0; a < d; ++a) CHECK(std::abs(l.u[a] - r.u[a]) < 1e-11);
            loudest = std::max(loudest, std::abs(l.p));
        }
        CHECK(loudest > 0.5);    // or these say nothing
    }
}

TEST_CASE("a pulse keeps its energy across two media", "[reference]") {
    const auto reference = crossing(1);
    const double whole = amplitude * amplitude * width * std::sqrt(std::numbers::pi / 2) / (first.rho0 * first.c0 * first.c0);
    for (const double lag : {-1.7, -0.3, 0.0, 0.1, 0.4, 3.0}) {
        const auto energy = [&](int side, const abi::Medium& medium) {
            return integral(20, width, 1, [&](std::vector<double> y) {
                for (double& value : y) {
                    const double x = interface_at + side * value;
                    const Field f = at(*reference, 1, arrival + lag, &x);
                    value = 0.5 * (f.p * f.p / (medium.rho0 * medium.c0 * medium.c0) + medium.rho0 * f.u[0] * f.u[0]);
                }
                return y;
            });
        };
        INFO(lag << " s after the crest came");
        CHECK(energy(-1, first) + energy(1, second) == Approx(whole).epsilon(1e-11));
    }
}

TEST_CASE("a pulse across any plane of space is the one along a line, from either medium", "[reference]") {
    const auto line = crossing(1);
    for (int d = 2; d <= 3; ++d) {
        const auto reference = crossing(d);
        for (const double x : {-2.0, -0.3, 0.5, 1.4}) {
            const Field expected = at(*line, 1, arrival + 0.3, &x);
            auto place = scaled(along(d), x);    // and off the way, along the interface
            place[0] += 0.7 * along(d)[1], place[1] -= 0.7 * along(d)[0];
            const Field found = at(*reference, d, arrival + 0.3, place.data());
            CHECK(std::abs(found.p - expected.p) < 1e-12);
            for (int a = 0; a < d; ++a) CHECK(std::abs(found.u[a] - along(d)[std::size_t(a)] * expected.u[0]) < 1e-12);
        }
    }
    // backwards, from what is the second medium of the list, with the media exchanged: the same seen in a mirror
    const auto mirror = prepared(halves({1}, second, first), 1,
                                 {{"amplitude", real_of(amplitude)}, {"width", real_of(width)}, {"direction", vector_of({-1})},
                                  {"interface", vector_of({interface_at})}, {"centre", vector_of({2 * interface_at - crest_at})}});
    for (const double x : {-2.0, -0.3, 0.5, 1.4}) {
        const double image = 2 * interface_at - x;
        const Field expected = at(*line, 1, arrival + 0.3, &x), found = at(*mirror, 1, arrival + 0.3, &image);
        CHECK(std::abs(found.p - expected.p) < 1e-12);
        CHECK(std::abs(found.u[0] + expected.u[0]) < 1e-12);
    }
}

TEST_CASE("in two equal media, one pulse each way is a pulse let go at rest", "[reference]") {
    auto whole = reference_with("pulse", {{"amplitude", real_of(2 * amplitude)}, {"width", real_of(width)}, {"centre", vector_of({crest_at})}});
    whole->prepare({.dimension = 1, .medium = first});
    MediaMap map(first);
    map.add(first, Region("x > 0.25 or x < -6.75", {}, 1, "contract"));
    Given forwards = pulse_along({1}), backwards = forwards;
    backwards["direction"] = vector_of({-1}), backwards["interface"] = vector_of({2 * crest_at - interface_at});
    const auto right = prepared(map, 1, forwards), left = prepared(map, 1, backwards);
    for (const double t : {0.0, 0.3, arrival, 2.5})
        for (const double x : {-9.0, -6.75, -4.1, -3.25, 0.1, 0.6, 1.9}) {
            const Field sum = at(*whole, 1, t, &x), r = at(*right, 1, t, &x), l = at(*left, 1, t, &x);
            CHECK(std::abs(r.p + l.p - sum.p) < 1e-12);
            CHECK(std::abs(r.u[0] + l.u[0] - sum.u[0]) < 1e-12);
        }
}

TEST_CASE("a pulse across two media needs an interface that is there", "[reference]") {
    const Given line = pulse_along({1}), plane = pulse_along({0.6, 0.8});
    const auto with = [](Given given, const char* name, const std::vector<double>& value) {
        given[name] = vector_of(value);
        return given;
    };
    const MediaMap media = halves({1}), alone(first);
    CHECK(prepared(media, 1, line)->several_media());
    const std::string beyond = "beyond the interface lie several media: put interface and direction where the media's regions meet, "
                               "with no third medium as near as centre";
    const std::string one = "there is one medium on both sides of the interface: give the second one the region beyond it";
    const std::string late = "centre does not lie before the interface: move it back along direction, or turn direction";
    CHECK_THROWS_WITH(prepared(alone, 1, line), one);
    CHECK_THROWS_WITH(prepared(media, 1, with(with(line, "interface", {4}), "centre", {1})), one);
    CHECK_THROWS_WITH(prepared(media, 1, with(line, "direction", {-1})), late);
    CHECK_THROWS_WITH(prepared(media, 1, with(line, "centre", {0.25})), late);
    CHECK_THROWS_WITH(prepared(media, 1, with(line, "direction", {0})), "direction has no length: give a vector other than zero");
    CHECK_THROWS_WITH(prepared(media, 1, with(line, "interface", {0, 0})), "interface needs one component per dimension");
    CHECK_THROWS_WITH(prepared(media, 1, with(line, "centre", {0, 0})), "centre needs one component per dimension");
    CHECK_THROWS_WITH(prepared(halves({0.8, 0.6}), 2, plane), "before" + beyond.substr(6));
    MediaMap layers(first);
    layers.add(second, Region("0.25 < x < 1", {}, 1, "contract"));
    CHECK_THROWS_WITH(prepared(layers, 1, line), beyond);
    CHECK_THROWS_WITH(prepared(media, 1, with(line, "interface", {0})), beyond);
}
