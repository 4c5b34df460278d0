/// What finite differences and the k-space method make of waves in one medium, in 1-D to 3-D.
#include "grids.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

/// Standing waves of `waves` per axis in a periodic box, n points per unit length, 1.25 periods: the error over the wave's own RMS.
double standing_error(const std::string& method, int dimension, const std::vector<int>& waves, int n, double courant) {
    double squares = 0;
    std::string k, zero;
    for (const int w : waves) {
        squares += 4 * pi * pi * w * w;
        k += (k.empty() ? "" : ",") + number(2 * pi * w);
        zero += (zero.empty() ? "" : ",") + number(0);
    }
    std::string p = "1";
    for (int a = 0; a < dimension; ++a) p += "*cos(" + number(2 * pi * waves[std::size_t(a)]) + "*" + "xyz"[a] + ")";
    double rms = 1;
    for (const int w : waves) rms *= w ? std::sqrt(0.5) : 1;
    const Case c = scene(periodic_box(dimension, n), {method, "/initial/p=" + p, "/integrator/courant=" + number(courant),
                                                      "/until=" + number(1.25 * 2 * pi / std::sqrt(squares) / 2),
                                                      R"(/reference={"type":"standing_wave","wave_number":[)" + k + R"(],"scale":)" + number(rms) + "}"});
    return run(c).errors->rms;
}

/// A travelling wave of `waves` per axis, `periods` of it.
double travelling_error(const std::string& method, int dimension, const std::vector<int>& waves, int n, double courant, double periods) {
    double squares = 0;
    std::string k;
    for (const int w : waves) {
        squares += 4 * pi * pi * w * w;
        k += (k.empty() ? "" : ",") + number(2 * pi * w);
    }
    const double length = std::sqrt(squares);
    std::string angle = "0", u;
    for (int a = 0; a < dimension; ++a) angle += "+" + number(2 * pi * waves[std::size_t(a)]) + "*" + "xyz"[a];
    for (int a = 0; a < dimension; ++a) u += (a ? ",\"" : "\"") + number(2 * pi * waves[std::size_t(a)] / length) + "*cos(" + angle + ")/(rho0*c0)\"";
    const Case c = scene(periodic_box(dimension, n), {method, "/initial={\"p\":\"cos(" + angle + ")\",\"u\":[" + u + "]}", "/integrator/courant=" + number(courant),
                                                      "/until=" + number(periods * pi / length), R"(/reference={"type":"travelling_wave","wave_number":[)" + k + "]}"});
    return run(c).errors->l2;
}

}    // namespace

TEST_CASE("finite differences of order two err as they are known to", "[methods]") {
    const std::pair<int, double> known[] = {{8, 0.156}, {16, 0.038}, {32, 0.0095}, {64, 0.0024}};
    for (const auto& [points, error] : known) {
        CAPTURE(points);
        CHECK(standing_error(fdtd, 2, {1, 0}, points, 0.5) == Approx(error).epsilon(0.03));
    }
}

TEST_CASE("the error of finite differences is that of their dispersion relation", "[methods]") {
    const double courant = GENERATE(0.1, 0.5);    // whole numbers of steps
    for (const int order : {2, 4})
        for (const int n : {10, 20}) {
            CAPTURE(courant, order, n);
            const double theta = pi / n, symbol = order == 2 ? std::sin(theta) : 9. / 8 * std::sin(theta) - 1. / 24 * std::sin(3 * theta);
            const double ratio = std::asin(courant * symbol) / (courant * theta), late = std::abs(std::cos(2.5 * pi * ratio));
            CHECK(standing_error(order == 2 ? fdtd : fdtd_4, 1, {1}, n, courant) == Approx(late).epsilon(1e-6));
        }
}

TEST_CASE("order four is of order four in space", "[methods]") {
    const double coarse = standing_error(fdtd_4, 2, {1, 1}, 12, 0.005), fine = standing_error(fdtd_4, 2, {1, 1}, 24, 0.005);
    CHECK(std::log2(coarse / fine) == Approx(4).margin(0.05));
}

TEST_CASE("a travelling wave sets out to one side only", "[methods]") {
    const double error = 2 * pi * std::abs(std::asin(0.5 * std::sin(pi / 16)) / (0.5 * pi / 16) - 1);    // of its phase after a period
    CHECK(travelling_error(fdtd, 1, {1}, 16, 0.5, 1) == Approx(2 * std::sin(error / 2)).epsilon(1e-3));
}

TEST_CASE("the k-space method is exact at four points per wavelength in one medium", "[methods]") {
    for (const double courant : {0.1, 0.5}) {
        CAPTURE(courant);
        CHECK(travelling_error(kspace, 1, {4}, 16, courant, 10) < 1e-10);
        CHECK(travelling_error(kspace, 2, {4, 0}, 16, courant, 10) < 1e-10);
        CHECK(travelling_error(kspace, 2, {3, 2}, 16, courant, 10) < 1e-10);
        CHECK(travelling_error(kspace, 3, {2, 2, 2}, 15, courant, 10) < 1e-10);
        CHECK(standing_error(kspace, 2, {2, 3}, 16, courant) < 1e-10);
    }
}

TEST_CASE("in space the k-space method does what it does to modes", "[methods]") {
    const std::string twice = R"json(/medium=[{"c0":2,"rho0":1.5},{"region":"x < 0.5","c0":2,"rho0":1.5}])json";    // two media by name only
    for (const int d : {1, 2, 3}) {
        const auto final_state = [&](const std::vector<std::string>& set) {
            const Case c = scene(periodic_box(d, 12), with(set, {kspace, "/initial/p=" + noise(d), "/until=0.3"}));
            Simulation simulation(c);
            simulation.run();
            return simulation.profile().p;
        };
        CHECK(largest_difference(final_state({}), final_state({twice})) < 1e-12);
    }
}

TEST_CASE("grids keep their energy", "[methods][energy]") {
    for (const std::string& method : {fdtd, fdtd_4, kspace})
        for (const int d : {1, 2, 3})
            for (const bool several : {false, true}) {
                CAPTURE(method, d, several);
                std::vector<std::string> set{method, "/initial/p=" + noise(d), "/integrator={\"type\":\"leapfrog\",\"safety\":0.9}", "/until=10"};
                if (several) set.push_back(R"json(/medium=[{"c0":2,"rho0":1.5},{"region":"x > 0.45","c0":1,"rho0":5}])json");
                const Summary s = run(scene(periodic_box(d, d == 3 ? 10 : 24), set));
                CHECK(std::abs(s.energy_final / s.energy_initial - 1) < 1e-12);
            }
}

TEST_CASE("a tone from a point has the monopole's amplitude on every grid", "[methods][point]") {
    const double dx = 0.05, c0 = 340, omega = 2 * pi * c0 / (8 * dx);
    for (const std::string& method : {fdtd, fdtd_4, kspace})
        for (const char* medium : {R"(/medium={"c0":340,"rho0":1.2})", R"(/medium=[{"c0":500,"rho0":3},{"c0":340,"rho0":1.2,"region":"-18 < x < 18"}])"}) {
            CAPTURE(method, medium);
            const Case c = scene(R"({"dimension": 1, "medium": {"c0": 340, "rho0": 1.2}, "particles": {"type": "lattice", "dx": 0.05, "lower": [-20], "upper": [20]},
                "boundaries": [{"type": "periodic", "face": "x"}], "sources": [{"type": "point", "flow": 0.01, "omega": )" + number(omega) + R"(}],
                "integrator": {"type": "leapfrog", "courant": 0.5}, "until": 0.045, "output": {"probes": [[2], [-3]]}})", {method, medium});
            Simulation simulation(c);
            simulation.run();
            for (const Complex p : demodulated(simulation.probes(), omega, 0.03)) CHECK(std::abs(p) == Approx(1.2 * c0 * 0.01 / 2).epsilon(1e-3));
        }
}

TEST_CASE("what a source imposes leaves its region as the wave that it is", "[methods]") {
    const std::string layer = R"json({"type":"absorbing_layer","face":"x","thickness":5,"attenuation":60})json";
    for (const std::string& method : {fdtd, fdtd_4, kspace}) {
        CAPTURE(method);
        const Case c = scene(R"json({"dimension": 1, "medium": {"c0": 340, "rho0": 1.2}, "particles": {"type": "lattice", "dx": 0.05, "lower": [-10], "upper": [20]},
            "sources": [{"type": "plane_wave", "region": "0 < x < 2", "amplitude": 3, "omega": 1000, "direction": [1]}],
            "integrator": {"type": "leapfrog", "courant": 0.5}, "until": 0.06, "output": {"probes": [[4], [7]]}})json", {method, "/boundaries=[" + layer + "]"});
        Simulation simulation(c);
        simulation.run();
        for (const Complex p : demodulated(simulation.probes(), 1000, 0.04)) CHECK(std::abs(p) == Approx(3).epsilon(0.01));
    }
}

TEST_CASE("threads of the k-space method share the work, not the result", "[methods]") {
    const auto final_state = [](const std::string& method) {
        const Case c = scene(periodic_box(2, 32), {method, R"json(/medium=[{"c0":2,"rho0":1.5},{"region":"x > 0.45","c0":1,"rho0":5}])json", "/initial/p=" + noise(2)});
        Simulation simulation(c);
        simulation.run();
        return simulation.profile().p;
    };
    CHECK(largest_difference(final_state(kspace), final_state(R"(/method={"type":"kspace","threads":2})")) < 1e-11);
}
