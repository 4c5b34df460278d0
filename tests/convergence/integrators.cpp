/// Orders of the integrators from p and u given at the same time.
#include <algorithm>

#include <sphonic/stability.hpp>

#include "../support/scene.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

/// A smooth right-going pulse, periodic with period 1, of half-width about 0.05 m.
double pulse(double x) { return std::exp(20 * (std::cos(2 * testing::pi * x) - 1)); }

Case pulse_case(int n, const std::string& integrator) {
    const std::string text = "exp(20*(cos(2*pi*x)-1))";
    return scene(periodic_box(1, n), {"/until=0.125", "/integrator/type=" + integrator, "/integrator/courant=0.25",
                                      "/initial/p=" + text, R"(/initial/u=[")" + text + R"(/rho0/c0"])"});
}

/// Relative error after a quarter of the periodic box (t = 0.125 s at c0 = 2 m/s); dt falls with dx.
double error_at(int n, const std::string& integrator) {
    const Case c = pulse_case(n, integrator);
    Simulation simulation(c);
    simulation.run();
    return pressure_error(simulation, [](double x) { return pulse(x - 0.25); });
}

/// Root mean square of the difference that two integrators leave in p at the same time.
double difference_at(int n, const std::string& one, const std::string& other) {
    const auto pressure = [n](const std::string& integrator) {
        const Case c = pulse_case(n, integrator);
        Simulation simulation(c);
        simulation.run();
        return simulation.profile().p;
    };
    const auto p = pressure(one), q = pressure(other);
    double squares = 0;
    for (std::size_t i = 0; i < p.size(); ++i) squares += (p[i] - q[i]) * (p[i] - q[i]);
    return std::sqrt(squares / n);
}

}    // namespace

TEST_CASE("a smooth pulse of given p and u converges with order two for leapfrog, rk2 and ab2", "[convergence]") {
    for (const char* integrator : {"leapfrog", "rk2", "ab2"}) {
        INFO(integrator);
        CHECK(std::log2(error_at(400, integrator) / error_at(800, integrator)) == Approx(2).margin(0.05));
    }
}

TEST_CASE("leapfrog from p and u at t = 0 is velocity Verlet, symplectic Euler is off by the first order of dt",
          "[convergence]") {
    CHECK(difference_at(400, "leapfrog", "velocity_verlet") < 1e-12);
    const double coarse = difference_at(400, "leapfrog", "symplectic_euler");
    const double fine = difference_at(800, "leapfrog", "symplectic_euler");
    CHECK(std::log2(coarse / fine) == Approx(1).margin(0.02));
}

TEST_CASE("schemes with u at half steps begin without an error of the second order", "[convergence]") {
    const double u = 0.1, k = 2 * testing::pi, along[3] = {1, 0, 0};
    for (const std::string integrator : {"leapfrog", "velocity_verlet"}) {
        const auto error = [&](double courant) {
            const std::vector<std::string> set{"/integrator/type=" + integrator, "/integrator/courant=" + Json(courant).dump(), "/initial/u=[\"0.1*sin(2*pi*x)\"]"};
            const Case probe = scene(periodic_box(1, 12), set);
            std::vector<std::string> all = set;
            all.push_back("/until=" + Json(0.5 * testing::pi / (probe.medium.c0 * dispersion(probe, k, along))).dump());    // a quarter of the set's own period
            const Case c = scene(periodic_box(1, 12), all);
            Simulation simulation(c);
            simulation.run();
            const Profile now = simulation.profile();
            const double loudest = *std::max_element(now.p.begin(), now.p.end());
            return std::abs(loudest / (c.medium.rho0 * c.medium.c0 * u) - 1);
        };
        INFO(integrator);
        CHECK(error(0.8) < 1e-3);    // (omega dt)^2/8 is 0.02
        CHECK(std::log2(error(0.8) / error(0.4)) > 3.7);
    }
}
