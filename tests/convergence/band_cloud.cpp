/// Operators fitted to a band on clouds: gradients, travelling waves, walls, and that nothing grows.
#include "../support/cloud.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

std::string phase(int dimension, const std::array<int, 3>& m) {
    std::string sum;
    for (int a = 0; a < dimension; ++a) sum += (a ? "+" : "") + number(2 * pi * m[std::size_t(a)]) + "*" + "xyz"[a];
    return sum;
}

double length(const std::array<int, 3>& m) { return std::sqrt(double(m[0] * m[0] + m[1] * m[1] + m[2] * m[2])); }

/// L2 after ten periods of a wave of m wavelengths across the box.
double travel(int dimension, int n, const std::array<int, 3>& m, const std::vector<std::string>& set) {
    std::string vector, u;
    for (int a = 0; a < dimension; ++a) {
        vector += (a ? "," : "") + number(2 * pi * m[std::size_t(a)]);
        u += (a ? ",\"" : "\"") + number(m[std::size_t(a)] / (length(m) * rho0 * c0)) + "*cos(" + phase(dimension, m) + ")\"";
    }
    const Case c = scene(periodic_box(dimension, n), with(set, {"/initial={\"p\":\"cos(" + phase(dimension, m) + ")\",\"u\":[" + u + "]}",
                                                                "/until=" + number(10 / (length(m) * c0)),
                                                                "/reference={\"type\":\"travelling_wave\",\"wave_number\":[" + vector + "]}"}));
    return run(c).errors->l2;
}

const std::string leapfrog = "/integrator/type=leapfrog", rk4 = "/integrator/type=rk4";

}    // namespace

TEST_CASE("on a cloud the fitted derivative of a plane wave is right", "[band][cloud]") {
    for (const std::array<int, 3> m : {std::array{4, 0, 0}, std::array{3, 0, 0}, std::array{2, 2, 0}, std::array{1, 3, 0}, std::array{1, 0, 0}}) {
        constexpr double first = 1e-7;    // a step from p = 0 leaves p = -dt rho0 c0^2 div u
        const double k = 2 * pi * length(m);
        std::string u;
        for (std::size_t a = 0; a < 2; ++a) u += (a ? ",\"" : "\"") + number(m[a] / length(m)) + "*cos(" + phase(2, m) + ")\"";
        const Case c = scene(periodic_box(2, 24), with(cloud(0.2, 1), {rk4, "/initial/u=[" + u + "]", "/until=" + number(first)}));
        Simulation simulation(c);
        simulation.run();
        const Profile now = simulation.profile();
        double squares = 0, norm = 0;
        for (std::size_t i = 0; i < now.p.size(); ++i) {
            const double exact = k * std::sin(2 * pi * (m[0] * now.x[0][i] + m[1] * now.x[1][i]));
            squares += std::pow(now.p[i] / (first * rho0 * c0 * c0) - exact, 2);
            norm += exact * exact;
        }
        INFO(24 / length(m) << " points per wavelength: " << std::sqrt(squares / norm));
        CHECK(std::sqrt(squares / norm) < 2e-3);
    }
}

TEST_CASE("a wave of eight points per wavelength crosses a cloud", "[band][cloud]") {
    for (const double jitter : {0.1, 0.2})
        for (const int seed : {1, 2}) {
            INFO("jitter " << jitter << ", seed " << seed);
            for (const std::array<int, 3> m : {std::array{3, 0, 0}, std::array{0, 3, 0}, std::array{2, 2, 0}}) {
                const int n = int(std::ceil(8 * length(m) - 1e-9));
                CHECK(travel(2, n, m, with(cloud(jitter, seed), {leapfrog, "/integrator/courant=0.5"})) < 1.7e-2);
                CHECK(travel(2, n, m, with(cloud(jitter, seed), {rk4, "/integrator/courant=0.4"})) < 1.7e-2);
            }
        }
    CHECK(travel(1, 24, {3, 0, 0}, with(cloud(0.2, 1), {leapfrog, "/integrator/courant=0.5"})) < 1.7e-2);
    CHECK(travel(3, 16, {2, 0, 0}, with(cloud(0.2, 1), {leapfrog, "/integrator/courant=0.4"})) < 2e-2);
}

TEST_CASE("the corrected gradient is far from that on the same cloud", "[band][cloud]") {
    CHECK(travel(2, 24, {3, 0, 0}, {"/equations=linear_acoustics", "/particles/jitter=0.2", "/integrator/courant=0.3"}) > 0.1);
}

TEST_CASE("a cloud with fitted weights lets no noise grow", "[band][cloud]") {
    for (const double jitter : {0.1, 0.2, 0.3}) {
        INFO("jitter " << jitter);
        CHECK(growth(1, 48, 2e4, 0.5, with(cloud(std::min(jitter, 0.2), 1), {leapfrog})) < 1);
        CHECK(growth(2, 16, 1e4, 0.5, with(cloud(jitter, 1), {leapfrog})) < 1);
        CHECK(growth(2, 16, 1e3, 0.5, with(cloud(jitter, 1), {rk4})) < 1);
        CHECK(growth(3, 8, 1e3, 0.4, with(cloud(jitter, 1), {leapfrog})) < 1);
    }
}

TEST_CASE("without its damping the same cloud blows up", "[band][cloud]") {
    const std::string bare = R"({"type":"band_fitted","damping":0})";
    CHECK(growth(2, 16, 200, 0.5, with(cloud(0.2, 1), {leapfrog, "/equations={\"p\":[{\"divergence\":\"u\",\"form\":" + bare +
                 ",\"times\":\"-rho0*c0^2\"}],\"u\":[{\"gradient\":\"p\",\"form\":" + bare + ",\"times\":\"-1/rho0\"}]}"})) > 2);
}

TEST_CASE("walls of a cloud keep what fitted operators gain", "[band][cloud]") {
    constexpr int n = 24;
    const std::array<double, 2> k{5 * pi, 3 * pi};
    const double omega = c0 * std::hypot(k[0], k[1]);
    for (const double jitter : {0.0, 0.2}) {
        const Case c = scene(periodic_box(2, n), with(cloud(jitter, 1), {leapfrog, "/integrator/courant=0.5", "/boundaries=[{\"type\":\"rigid\",\"face\":\"all\"}]",
                                                                         "/initial/p=cos(" + number(k[0]) + "*x)*cos(" + number(k[1]) + "*y)",
                                                                         "/until=" + number(10 * 2 * pi / omega)}));
        Simulation simulation(c);
        const Profile start = simulation.profile();
        simulation.run();
        const Profile now = simulation.profile();
        double squares = 0, norm = 0;
        for (std::size_t i = 0; i < now.p.size(); ++i) squares += std::pow(now.p[i] - start.p[i], 2), norm += start.p[i] * start.p[i];
        INFO("jitter " << jitter);
        CHECK(std::sqrt(squares / norm) < 1e-2);
    }
    CHECK(growth(2, 16, 1e4, 0.5, with(cloud(0.2, 1), {leapfrog, R"(/boundaries=[{"type":"rigid","face":"x_min"},{"type":"rigid","face":"x_max"},
                 {"type":"soft","face":"y_min"},{"type":"rigid","face":"y_max"}])"})) < 1);
}
