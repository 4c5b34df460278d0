/// Bodies on grids: staircases of cells.
#include "grids.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

std::string body(const std::string& members) { return "/obstacles=[{" + members + "}]"; }
std::string round_body(int d, const std::string& centre, const std::string& wall) {
    return body(R"("type":"expression","surface":"(x-)" + centre + ")^2" + (d > 1 ? "+(y-" + centre + ")^2" : "") + (d > 2 ? "+(z-" + centre + ")^2" : "") +
                R"( - 0.07","wall":")" + wall + '"');
}

/// Two walls and a wave between them that has run against both, in a box of which a body fills what lies beyond x = 0.75.
std::vector<double> before_slab(int d, int n, const std::string& method, const std::string& wall, bool slab) {
    const double dx = 1.0 / n;
    std::string lower = "0", upper = slab ? "1" : number(0.75 - dx / 2), shape = wall == "rigid" ? "cos(pi*x/0.75)" : "sin(pi*x/0.75)", faces = face("x_min", wall);
    for (int a = 1; a < d; ++a) lower += ",0", upper += ",1", shape += std::string("*cos(pi*") + "xyz"[a] + ")", faces += "," + face(std::string(1, "xyz"[a]), "rigid");
    if (!slab) faces += "," + face("x_max", wall, "half_way");
    std::vector<std::string> set{method, "/particles/lower=[" + lower + "]", "/particles/upper=[" + upper + "]", "/particles/dx=" + number(dx), "/boundaries=[" + faces + "]",
                                 "/initial/p=" + shape, "/integrator/courant=0.3", "/until=0.9"};
    if (slab) set.push_back(body(R"("type":"expression","surface":"0.75 - )" + number(dx / 2 * (n % 4 == 0)) + R"( - x","wall":")" + wall + '"'));
    const Case c = scene(periodic_box(d, n), set);
    Simulation simulation(c);
    simulation.run();
    return simulation.profile().p;
}

}    // namespace

TEST_CASE("energy is constant about bodies of all kinds", "[methods][body][energy]") {
    for (const std::string& method : {fdtd, fdtd_4})
        for (const std::string wall : {"rigid", "soft", "free"})
            for (const int d : {1, 2, 3})
                for (const std::string centre : {"0.5", "0.08"})    // in the box, and through its faces
                    for (const std::string& faces : {face("all", "periodic"), face("all", "rigid"), face("all", "soft", "half_way"), face("all", "rigid", "half_way")}) {
                        CAPTURE(method, wall, d, centre, faces);
                        const Summary s = run(scene(periodic_box(d, d == 3 ? 9 : 21), {method, "/boundaries=[" + faces + "]", round_body(d, centre, wall), "/initial/p=" + noise(d),
                                                                                     R"(/integrator={"type":"leapfrog","safety":1})", "/until=5"}));
                        CHECK(s.energy_initial > 0);
                        CHECK(std::abs(s.energy_final / s.energy_initial - 1) < 1e-12);
                    }
}

TEST_CASE("a body's side along the grid is the wall half a spacing before its points", "[methods][body]") {
    for (const std::string wall : {"rigid", "soft"})
        for (const int d : {1, 2, 3}) {
            CAPTURE(wall, d);
            CHECK(largest_difference(before_slab(d, 12, fdtd, wall, true), before_slab(d, 12, fdtd, wall, false)) < 1e-12);
            const double coarse = largest_difference(before_slab(d, 12, fdtd_4, wall, true), before_slab(d, 12, fdtd_4, wall, false));
            const double fine = largest_difference(before_slab(d, 24, fdtd_4, wall, true), before_slab(d, 24, fdtd_4, wall, false));
            CAPTURE(coarse, fine);
            CHECK(coarse < 0.1);
            CHECK(coarse / fine > 1.8);
        }
}

TEST_CASE("a circle as a staircase converges, at first order at least", "[methods][body]") {
    for (const std::string wall : {"rigid", "soft"})
        for (const bool second : {true, false}) {    // order 2 has errors of its own on coarse grids
            const auto error = [&](double dx) {
                return run(repository_case("suite/circle_scattering_2d", {second ? fdtd : fdtd_4, "/obstacles/0/wall=" + wall, "/reference/wall=" + wall,
                                                                          "/particles/dx=" + number(dx), "/integrator/courant=0.6"})).errors->l2;
            };
            const double finest = second ? 0.0125 : 0.025, fine = error(finest), coarse = error(4 * finest);
            CAPTURE(wall, second, coarse, fine);
            CHECK(std::log2(coarse / fine) / 2 > 0.7);
            CHECK(fine < 0.05);
        }
}

TEST_CASE("the stable step of a grid with bodies is that of the grid", "[methods][body]") {
    for (const std::string& method : {fdtd, fdtd_4})
        for (const std::string wall : {"rigid", "soft"})
            for (const int d : {2, 3}) {
                const auto outcome = [&](double safety) {
                    return run(scene(periodic_box(d, 12), {method, round_body(d, "0.5", wall), "/initial/p=" + noise(d), "/until=6",
                                                            R"(/integrator={"type":"leapfrog","unstable":"allow","safety":)" + number(safety) + "}"})).diverged;
                };
                CAPTURE(method, wall, d);
                CHECK_FALSE(outcome(0.999));
                CHECK(outcome(1.05));
            }
}

TEST_CASE("a grid shows no points in bodies, and sources act on none", "[methods][body]") {
    const std::string source = R"(/sources=[{"type":"plane_wave","omega":5,"region":"x < 0.6"}])";
    const Case grid = scene(periodic_box(2, 20), {fdtd, round_body(2, "0.5", "rigid"), source, "/until=1"});
    Simulation simulation(grid);
    simulation.run();
    const Profile now = simulation.profile();
    CHECK(long(now.p.size()) == grid.particles);
    for (std::size_t i = 0; i < now.p.size(); ++i) CHECK(std::pow(now.x[0][i] - 0.5, 2) + std::pow(now.x[1][i] - 0.5, 2) >= 0.07 - 1e-12);
    const Case within = scene(periodic_box(2, 20), {fdtd, round_body(2, "0.5", "rigid"), R"(/sources=[{"type":"plane_wave","omega":5,"region":"abs(x-0.5) + abs(y-0.5) < 0.1"}])"});
    CHECK_THROWS_WITH(Simulation(within), Catch::Contains("/sources/0"));
}
