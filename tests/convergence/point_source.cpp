/// The point source against the field of an exact monopole: amplitude, silence of the sawtooth, and the shape of pulses.
#include "../support/scene.hpp"
#include "../support/waves.hpp"

#include <sphonic/stability.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

constexpr double c0 = 340, rho0 = 1.2, flow = 0.01;
constexpr double loudness = rho0 * c0 * flow / 2;    ///< rho0 c0 Q / 2, on either side in 1-D

/// 40 m of a line with a source in its middle.
std::string line(double dx, const std::string& source) {
    return R"({"dimension": 1, "medium": {"c0": 340, "rho0": 1.2},
        "particles": {"type": "lattice", "dx": )" + Json(dx).dump() + R"(, "lower": [-20], "upper": [20]},
        "kernel": {"type": "cubic_spline", "h_over_dx": 1}, "equations": "linear_acoustics",
        "boundaries": [{"type": "periodic", "face": "x"}], "sources": [)" + source + R"(],
        "integrator": {"type": "leapfrog", "courant": 0.5}, "until": 0.055})";
}

/// Amplitudes in p over lower <= x <= upper of the waves of two wave numbers, each with its opposite.
std::pair<double, double> amplitudes(const Profile& now, double lower, double upper, double k, double other) {
    std::vector<Complex> p;
    std::vector<std::vector<Complex>> waves(4);
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        const double x = now.x[0][i];
        if (x < lower || x > upper) continue;
        p.push_back(now.p[i]);
        waves[0].push_back(std::cos(k * x)), waves[1].push_back(std::sin(k * x));
        waves[2].push_back(std::cos(other * x)), waves[3].push_back(std::sin(other * x));
    }
    const auto a = fitted(p, waves).amplitude;
    return {std::hypot(a[0].real(), a[1].real()), std::hypot(a[2].real(), a[3].real())};
}

struct Tone {
    double amplitude;    ///< over the exact monopole's
    double sawtooth;     ///< over the wave's own
};

Tone tone(double per_wavelength, const std::vector<std::string>& set) {
    const double dx = 0.05, omega = 2 * pi * c0 / (per_wavelength * dx);
    const Case c = scene(line(dx, R"({"type": "point", "flow": 0.01, "omega": )" + Json(omega).dump() + "}"), set);
    Simulation simulation(c);
    simulation.run();
    const auto response = tone_response(c, omega, simulation.summary().dt);
    REQUIRE(response);
    const double k = response->wave_number;
    const auto [wave, sawtooth] = amplitudes(simulation.profile(), 1.5, 4.5, k, pi / dx - k);    // F(pi/dx - k) = F(k) at h = dx
    return {wave / loudness, sawtooth / wave};
}

}    // namespace

TEST_CASE("a tone from a point has the monopole's amplitude and no sawtooth", "[point]") {
    const auto integrator = GENERATE(as<std::string>(), "leapfrog", "symplectic_euler", "velocity_verlet", "rk4");
    const double courant = GENERATE(0.1, 0.5, 0.7);
    if (integrator == "rk4" && courant > 0.1) return;    // it damps the wave on its way, by 5 % at 0.7
    for (const double per_wavelength : {8.0, 12.0, 20.0}) {
        INFO(integrator << ", Courant " << courant << ", " << per_wavelength << " points per wavelength");
        const Tone t = tone(per_wavelength, {"/integrator/type=" + integrator, "/integrator/courant=" + Json(courant).dump()});
        CHECK(t.amplitude == Approx(1).epsilon(0.002));
        CHECK(t.sawtooth < 1e-3);
    }
}

TEST_CASE("without its footprint the point source would ring: a narrow one drives the sawtooth", "[point]") {
    CHECK(tone(8, {"/sources/0/width_over_dx=1.5"}).sawtooth > 0.05);
}

TEST_CASE("pulses leave a point as they are named, with order two", "[point]") {
    const auto signal = GENERATE(as<std::string>(), "gaussian", "ricker");
    const double duration = 5e-3, delay = 5 * duration;
    const auto error = [&](double dx) {
        const Case c = scene(line(dx, R"({"type": "point", "flow": 0.01, "signal": ")" + signal + R"(", "duration": 0.005, "position": [0.013]})"));
        Simulation simulation(c);
        simulation.run();
        return pressure_error(simulation, [&](double x) {
            const double s = (c.until - std::abs(x - 0.013) / c0 - delay) / duration;
            return loudness * std::exp(-s * s) * (signal == "ricker" ? 1 - 2 * s * s : 1);
        });
    };
    const double coarse = error(0.1), fine = error(0.05);
    INFO(signal << ": L2 " << coarse << ", " << fine);
    CHECK(fine < 0.03);
    CHECK(std::log2(coarse / fine) == Approx(2).margin(0.15));
}

TEST_CASE("equations in density take the same source", "[point]") {
    const std::vector<std::string> density{
        R"(/equations={"drho":[{"divergence":"u","form":"difference","times":"-rho0"}],"p":{"state":"acoustic","of":"drho"},"u":[{"gradient":"p","form":"sum","times":"-1/rho0"}]})"};
    CHECK(tone(12, density).amplitude == Approx(1).epsilon(0.002));
}

TEST_CASE("finite differences take the same source", "[point]") {
    const double dx = 0.05, omega = 2 * pi * c0 / (8 * dx);
    const Case c = scene(line(dx, R"({"type": "point", "flow": 0.01, "omega": )" + Json(omega).dump() + "}"), {R"(/method={"type":"fdtd"})"});
    Simulation simulation(c);
    simulation.run();
    const double dt = simulation.summary().dt, k = 2 / dx * std::asin(std::sin(omega * dt / 2) * dx / (c0 * dt));
    CHECK(amplitudes(simulation.profile(), 3, 7, k, pi / dx - k).first == Approx(loudness).epsilon(0.002));
}

TEST_CASE("a tone in the plane spreads as the exact circular wave", "[point]") {
    const double dx = 0.05, omega = 2 * pi * c0 / (12 * dx), k = omega / c0;
    const std::string text = R"({"dimension": 2, "medium": {"c0": 340, "rho0": 1.2},
        "particles": {"type": "lattice", "dx": 0.05, "lower": [-6, -6], "upper": [6, 6]},
        "kernel": {"type": "quintic_spline", "h_over_dx": 1}, "equations": "linear_acoustics",
        "boundaries": [{"type": "periodic", "face": "all"}],
        "sources": [{"type": "point", "flow": 0.01, "omega": )" + Json(omega).dump() + R"(}],
        "integrator": {"type": "leapfrog", "courant": 0.5}, "until": 0.017, "output": {"probes": [[2.5, 0], [1.75, 1.75], [2.3, 1]]}})";
    const Case c = scene(text);
    Simulation simulation(c);
    simulation.run();
    const ProbeRecord& probes = simulation.probes();
    for (std::size_t i = 0; i < probes.p.size(); ++i) {
        const double r = std::hypot(probes.read_at[i][0], probes.read_at[i][1]);
        std::complex<double> sum = 0;    // over the last three periods
        const double begin = c.until - 3 * 2 * pi / omega;
        int n = 0;
        for (std::size_t s = 0; s < probes.t.size(); ++s)
            if (probes.t[s] > begin) sum += probes.p[i][s] * std::polar(1.0, omega * probes.t[s]), ++n;
        const double exact = rho0 * omega * flow / 4 * std::hypot(std::cyl_bessel_j(0, k * r), std::cyl_neumann(0, k * r));
        INFO("r = " << r);
        CHECK(2 * std::abs(sum) / n == Approx(exact).epsilon(0.03));
    }
}
