/// The reference scattered_wave: a plane tone and a circle.
#include <complex>

#include "reference_fields.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

using Complex = std::complex<double>;

const abi::Medium medium{2, 1.5};
constexpr double amplitude = 3, radius = 0.4, impedance = 3, forwards = 0.7;    // [Pa], [m], rho0 c0, direction's angle
const std::vector<double> centre{0.1, -0.2};

Given scene(double ka, const char* wall, const char* field) {
    return {{"amplitude", real_of(amplitude)}, {"omega", real_of(ka / radius * medium.c0)}, {"radius", real_of(radius)},
            {"direction", vector_of({3 * std::cos(forwards), 3 * std::sin(forwards)})}, {"centre", vector_of(centre)},
            {"wall", text_of(wall)}, {"field", text_of(field)}};
}

std::unique_ptr<abi::Reference> prepared(const Given& given, int d = 2) {
    auto reference = reference_with("scattered_wave", given);
    reference->prepare({.dimension = d, .medium = medium});
    return reference;
}

struct Place {
    double x[2];
};
/// At distance r from the centre, phi from the direction.
Place polar(double r, double phi) { return {{centre[0] + r * std::cos(forwards + phi), centre[1] + r * std::sin(forwards + phi)}}; }

/// p and the velocity along r and phi as complex amplitudes: p(t) = Re(p exp(-i omega t)).
struct Tone {
    Complex p, u_r, u_phi;
};
Tone tone(const abi::Reference& reference, double ka, double r, double phi) {
    const double quarter = pi / 2 / (ka / radius * medium.c0), c = std::cos(forwards + phi), s = std::sin(forwards + phi);
    const Place place = polar(r, phi);
    const Field now = at(reference, 2, 0, place.x), later = at(reference, 2, quarter, place.x);
    return {{now.p, later.p}, {c * now.u[0] + s * now.u[1], c * later.u[0] + s * later.u[1]},
            {c * now.u[1] - s * now.u[0], c * later.u[1] - s * later.u[0]}};
}

/// Kirchhoff's integral over a circle about the scatterer at great distance, where p = i A F(phi) sqrt(2/(pi k r)) exp(i k r - i pi/4):
///   F = (i/4) closed integral of psi dE/dn - E dpsi/dn,   psi = p/(i A),   E = exp(-i k r' cos(phi' - phi)).
struct FarField {
    double ka, k = ka / radius;
    std::vector<Tone> tones;
    static constexpr double around = 1.5 * radius;

    FarField(double ka, const char* wall) : ka(ka) {
        const auto scattered = prepared(scene(ka, wall, "scattered"));
        const int n = int(6 * ka) + 64;    // the integrand's Fourier series ends before: the sum errs less than rounding
        for (int i = 0; i < n; ++i) tones.push_back(tone(*scattered, ka, around, 2 * pi * i / n));
    }
    Complex F(double phi) const {
        const Complex i_unit(0, 1);
        Complex sum;
        for (std::size_t i = 0; i < tones.size(); ++i) {
            const double cosine = std::cos(2 * pi * double(i) / double(tones.size()) - phi);
            const Complex E = std::polar(1.0, -k * around * cosine), p_slope = i_unit * k * impedance * tones[i].u_r;
            sum += (tones[i].p * -i_unit * k * cosine * E - E * p_slope) / (i_unit * amplitude);
        }
        return 0.25 * i_unit * sum * (2 * pi * around / double(tones.size()));
    }
    /// Scattered power over incident intensity [m]: from the far field, and from what flows out through the circle.
    double width() const {
        double sum = 0;
        for (std::size_t i = 0; i < tones.size(); ++i) sum += std::norm(F(2 * pi * double(i) / double(tones.size())));
        return 2 / (pi * k) * sum * 2 * pi / double(tones.size());
    }
    double width_nearby() const {
        double sum = 0;
        for (const Tone& at : tones) sum += (at.p * std::conj(at.u_r)).real();
        return sum * impedance / (amplitude * amplitude) * 2 * pi * around / double(tones.size());
    }
};

}    // namespace

TEST_CASE("a circle's wall holds the total field: no velocity across a rigid one, no pressure on a soft one", "[reference]") {
    for (const double ka : {1e-3, 0.3, 4.7, 25.0})
        for (const std::string wall : {"rigid", "soft"}) {
            INFO(wall << " circle, ka = " << ka);
            const auto total = prepared(scene(ka, wall.c_str(), "total"));
            double held = 0, free = 0, faintest = amplitude;
            for (int i = 0; i < 90; ++i) {
                const Tone f = tone(*total, ka, radius, 2 * pi * i / 90);
                held = std::max(held, wall == "rigid" ? impedance * std::abs(f.u_r) : std::abs(f.p));
                const double there = wall == "rigid" ? std::abs(f.p) : impedance * std::abs(f.u_r);
                free = std::max(free, there), faintest = std::min(faintest, there);
            }
            CHECK(held < 1e-12 * amplitude);
            CHECK(free > 0.9 * amplitude);
            CHECK(faintest > 0);    // points of the circle lie outside, whichever way they are rounded
        }
}

TEST_CASE("a wave around a circle solves linear acoustics and the Helmholtz equation", "[reference]") {
    for (const char* field : {"total", "scattered"})
        for (const char* wall : {"rigid", "soft"})
            for (const Place place : {polar(0.42, 0.2), polar(0.6, -1.9), polar(1.3, 2.8), polar(4, 0.4)})
                for (const double ka : {0.8, 2.0}) {
                    INFO(field << " field, " << wall << " circle, ka = " << ka << " at " << place.x[0] << ", " << place.x[1]);
                    const auto reference = prepared(scene(ka, wall, field));
                    const double t = 0.3, e = 1e-3, k = ka / radius, p = at(*reference, 2, t, place.x).p;
                    check_acoustics(*reference, medium, 2, t, place.x, k * amplitude);
                    double laplacian = 0;
                    for (int a = 0; a < 2; ++a) {
                        const auto moved = [&](double by) {
                            Place other = place;
                            other.x[a] += by * e;
                            return at(*reference, 2, t, other.x).p;
                        };
                        laplacian += (16 * (moved(1) + moved(-1)) - moved(2) - moved(-2) - 30 * p) / (12 * e * e);
                    }
                    CHECK(std::abs(laplacian + k * k * p) < 1e-8 * k * k * amplitude);
                }
}

TEST_CASE("the total field is the plane wave and the scattered field, and both are zero inside the circle", "[reference]") {
    for (const char* wall : {"rigid", "soft"}) {
        const double ka = 2, k = ka / radius, t = 0.3;
        const auto total = prepared(scene(ka, wall, "total")), scattered = prepared(scene(ka, wall, "scattered"));
        for (const Place place : {polar(0.4, 0.2), polar(0.6, -1.9), polar(4, 0.4)}) {
            const double n[2] = {std::cos(forwards), std::sin(forwards)};
            const double p = amplitude * std::sin(k * medium.c0 * t - k * (n[0] * (place.x[0] - centre[0]) + n[1] * (place.x[1] - centre[1])));
            const Field all = at(*total, 2, t, place.x), added = at(*scattered, 2, t, place.x);
            CHECK(std::abs(all.p - added.p - p) < 1e-13 * amplitude);
            for (int a = 0; a < 2; ++a) CHECK(std::abs(all.u[a] - added.u[a] - n[a] * p / impedance) < 1e-13 * amplitude);
        }
        for (const Place place : {polar(0, 0), polar(0.399, 1)}) {
            const Field inside = at(*total, 2, t, place.x);
            CHECK((inside.p == 0 && inside.u[0] == 0 && inside.u[1] == 0));
        }
    }
}

TEST_CASE("the optical theorem: a circle's shadow takes the power that it scatters", "[reference]") {
    for (const double ka : {0.05, 1.0, 3.83, 12.0})
        for (const char* wall : {"rigid", "soft"}) {
            INFO(wall << " circle, ka = " << ka);
            const FarField far(ka, wall);
            const double width = far.width();
            CHECK(far.width_nearby() == Approx(width).epsilon(1e-10));    // positive: it runs outwards
            CHECK(-4 / far.k * far.F(0).real() == Approx(width).epsilon(1e-10));
        }
}

TEST_CASE("a circle much smaller than the wave scatters as Rayleigh's, one much larger as its shadow", "[reference]") {
    // with z = ka, as far as z^2: rigid F = -(i pi/4) z^2 (1 - 2 cos phi), soft F = -1/(1 + (2i/pi)(ln(z/2) + Euler's constant)) - (i pi/2) z^2 cos phi
    const double small = 1e-3;
    const FarField rigid(small, "rigid"), soft(small, "soft");
    for (const double phi : {0.0, 0.8, 2.0, pi}) {
        CHECK(std::abs(rigid.F(phi) + Complex(0, pi * small * small / 4) * (1 - 2 * std::cos(phi))) < 2e-5 * small * small);
        const Complex round = 1. / Complex(1, 2 / pi * (std::log(small / 2) + std::numbers::egamma));
        CHECK(std::abs(soft.F(phi) + round + Complex(0, pi / 2 * small * small) * std::cos(phi)) < 1e-2 * small * small);
    }
    // potential flow about it: at its sides twice the velocity
    const Tone side = tone(*prepared(scene(small, "rigid", "total")), small, radius, pi / 2);
    CHECK(impedance * std::abs(side.u_phi) == Approx(2 * amplitude).epsilon(1e-5));
    // Wu (1956): width/(4 a) = 1 + 0.49807659 z^(-2/3) - 0.01117656 z^(-4/3) (soft), 1 - 0.43211998 z^(-2/3) - 0.21371236 z^(-4/3) (rigid)
    const double large = 60, z = std::pow(large, -2. / 3);
    CHECK(FarField(large, "soft").width_nearby() / (4 * radius) == Approx(1 + 0.49807659 * z - 0.01117656 * z * z).epsilon(1e-4));
    CHECK(FarField(large, "rigid").width_nearby() / (4 * radius) == Approx(1 - 0.43211998 * z - 0.21371236 * z * z).epsilon(1e-4));
}

TEST_CASE("a scattered wave turns with its direction and moves with its centre", "[reference]") {
    Given straight = scene(2, "rigid", "total");
    straight.erase("direction"), straight.erase("centre");
    const auto plain = prepared(straight), turned = prepared(scene(2, "rigid", "total"));
    for (const double phi : {0.3, -1.2, 2.9}) {
        const Place from{{0.9 * std::cos(phi), 0.9 * std::sin(phi)}}, to = polar(0.9, phi);
        const Field expected = at(*plain, 2, 0.2, from.x), found = at(*turned, 2, 0.2, to.x);
        CHECK(std::abs(found.p - expected.p) < 1e-13 * amplitude);
        const double c = std::cos(forwards), s = std::sin(forwards);
        CHECK(std::abs(found.u[0] - (c * expected.u[0] - s * expected.u[1])) < 1e-13 * amplitude);
        CHECK(std::abs(found.u[1] - (s * expected.u[0] + c * expected.u[1])) < 1e-13 * amplitude);
    }
}

TEST_CASE("a circle needs the plane", "[reference]") {
    Given line = scene(2, "rigid", "total");
    line.erase("direction"), line.erase("centre");
    for (const int d : {1, 3}) CHECK_THROWS_WITH(prepared(line, d), "a circle lies in the plane: it needs two dimensions");
    line["centre"] = vector_of({1});
    CHECK_THROWS_WITH(prepared(line), "centre needs one component per dimension");
    line = scene(2, "rigid", "total");
    line["direction"] = vector_of({0, 0});
    CHECK_THROWS_WITH(prepared(line), "direction has no length: give a vector other than zero");
}
