/// A wall of given impedance: what it reflects at which angle, and what it takes.
#include "../support/scene.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

/// Waves of length 1 m at an angle [degrees], in a packet that meets the wall at x_max; one wave along y fits the height.
struct Packet {
    double angle, per_wavelength;
    std::vector<std::string> set{};

    /// The largest pressure that comes back, over that sent: the packet has spread by then, but alike before all walls.
    double returned(double impedance) const {
        const double c = std::cos(angle * testing::pi / 180), s = std::sin(angle * testing::pi / 180), height = angle > 0 ? 1 / s : 0.5;
        const double dx = height / std::round(per_wavelength * height), width = 3 / c, start = 3 + 3.5 * width, end = std::round(2 * start / dx) * dx;
        const auto text = [](double x) { return Json(x).dump(); };
        const std::string packet = "exp(-((x - " + text(start) + ")/" + text(width) + ")^2)*cos(2*pi*(" + text(c) + "*(x - " + text(start) + ") + " + text(s) + "*y))";
        std::vector<std::string> all{"/particles/dx=" + text(dx), "/particles/upper=[" + text(end) + "," + text(height) + "]",
            "/boundaries/2={\"type\":\"impedance\",\"face\":\"x_max\",\"impedance\":" + text(impedance) + "}", "/initial/p=" + packet,
            "/initial/u=[\"" + text(c) + "*" + packet + "\",\"" + text(s) + "*" + packet + "\"]", "/until=" + text(2 * (end - start) / c),
            "/reference/region=3 < x < " + text(end - 3)};
        all.insert(all.end(), set.begin(), set.end());
        return run(repository_case("scenes/layer_2d", all)).errors->max;
    }
    /// |R| measured less exact, for rho0 c0 = 1; in magnitude.
    std::vector<double> errors(const std::vector<double>& impedances) const {
        const double from_rigid = returned(1e12);
        std::vector<double> all;
        for (const double impedance : impedances) {
            const double own = impedance * std::cos(angle * testing::pi / 180);
            all.push_back(std::abs(returned(impedance) / from_rigid - std::abs((own - 1) / (own + 1))));
        }
        return all;
    }
};

/// A box with walls of impedance Z = ratio rho0 c0 all around, and noise in it.
std::string leaking_box(double ratio) { return "/boundaries=[{\"type\":\"impedance\",\"face\":\"all\",\"impedance\":" + Json(3 * ratio).dump() + "}]"; }
std::vector<std::string> noise(int dimension) {
    const std::string p = "sin(9127*x + 31*x^2" + std::string(dimension > 1 ? " + 7919*y + 53*x*y" : "") + (dimension > 2 ? " + 6011*z" : "") + ")";
    return {"/initial/p=" + p};
}

}    // namespace

TEST_CASE("an impedance wall reflects (Z cos t - rho0 c0)/(Z cos t + rho0 c0), and what is beyond falls with the square of dx", "[wall][impedance]") {
    const std::vector<double> impedances{0.5, 1, 2, 5};
    std::vector<double> at_right_angles;
    for (const double angle : {0.0, 45.0, 60.0}) {
        const auto errors = Packet{angle, 20}.errors(impedances);
        for (std::size_t i = 0; i < errors.size(); ++i) {
            INFO("Z = " << impedances[i] << " rho0 c0 at " << angle << " degrees");
            CHECK(errors[i] < 0.02);
        }
        if (angle == 0) at_right_angles = errors;
    }
    const auto coarse = Packet{0, 10}.errors(impedances);
    for (std::size_t i = 0; i < coarse.size(); ++i) CHECK(at_right_angles[i] < coarse[i] / 3);
}

TEST_CASE("an impedance wall works with corrected weights, whose waves are slower", "[wall][impedance]") {
    const Packet packet{0, 40, {"/equations=corrected_acoustics", "/integrator/courant=0.5"}};
    for (const double error : packet.errors({0.5, 1, 2})) CHECK(error < 0.02);
}

TEST_CASE("impedance walls take energy from any field at every step, edges and corners too", "[wall][impedance]") {
    for (const int d : {1, 2, 3})
        for (const double ratio : {0.05, 0.5, 1.0, 20.0})
            for (const char* equations : {"corrected_acoustics", "band_fitted_acoustics"}) {
                INFO(d << "-D, Z = " << ratio << " rho0 c0, " << equations);
                std::vector<std::string> set = noise(d);
                set.insert(set.end(), {leaking_box(ratio), "/integrator/type=leapfrog", "/integrator/courant=0.45", "/kernel/h_over_dx=1.2", "/until=2", std::string("/equations=") + equations});
                const Case c = scene(periodic_box(d, d == 3 ? 10 : 20), set);
                Simulation simulation(c);
                abi::Solver& solver = simulation.solver();
                solver.step();    // from then on the energy is the staggered one
                const double start = solver.energy();
                double last = start;
                while (solver.time() < c.until) {
                    solver.step();
                    const double now = solver.energy();
                    REQUIRE(now <= last + 1e-13 * start);
                    last = now;
                }
                CHECK(last < 0.9 * start);
            }
}

TEST_CASE("pairs kept by a list meet an impedance wall as a stencil does", "[wall][impedance][tiers]") {
    for (const int d : {1, 2}) {
        std::vector<std::string> set = {leaking_box(0.7), "/integrator/type=leapfrog", "/kernel/h_over_dx=1.3", "/initial/p=exp(-((x-0.4)/0.15)^2)", "/until=0.3"};
        const auto end = [&] {
            const Case c = scene(periodic_box(d, 20), set);
            Simulation simulation(c);
            simulation.run();
            return simulation.profile().p;
        };
        const auto stencil = end();
        set.push_back("/particles/neighbours=frozen");
        const auto list = end();
        for (std::size_t i = 0; i < list.size(); ++i) REQUIRE(list[i] == Approx(stencil[i]).margin(1e-12));
    }
}
