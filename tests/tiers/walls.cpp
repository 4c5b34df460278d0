/// Mirror walls of sets with a neighbour list, by virtual particles.
#include "sound.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

struct Pair {
    const char *divergence, *gradient;
};
constexpr Pair adjoint_pairs[] = {{"difference", "sum"}, {"corrected", "corrected_adjoint"}};

/// On all faces, or on those of y and z with a periodic x.
std::string walls(int dimension, const std::string& type, const std::string& place, bool x_too = true) {
    if (x_too) return "/boundaries=[" + face("all", type, place) + "]";
    return "/boundaries=[" + face("x", "periodic") + "," + face("y", type, place) + (dimension > 2 ? "," + face("z", type, place) : "") + "]";
}

/// A rigid and a soft wall, one on particles and one half-way, at the ends of an axis; another axis simply ends.
const std::string mixed = "/boundaries=[" + face("x_min", "rigid", "half_way") + "," + face("x_max", "soft", "on_particles") + "," +
                          face("y_min", "soft", "half_way") + "," + face("y_max", "free") + "]";

/// For all walls and places in 1-D to 3-D.
template <class Check>
void for_walls(Check check) {
    for (const int d : {1, 2, 3})
        for (const char* type : {"rigid", "soft"})
            for (const char* place : {"on_particles", "half_way"}) {
                INFO(d << "-D, " << type << " " << place);
                check(d, walls(d, type, place));
                if (d > 1) check(d, walls(d, type, place, false));
            }
    check(2, mixed);
}

}    // namespace

TEST_CASE("walls of kept pairs and of a moving list agree with those of the stencil on a frozen lattice", "[tiers][wall]") {
    for_walls([](int d, const std::string& boundaries) {
        for (const Pair pair : adjoint_pairs)
            for (const bool viscous : {false, true}) {
                std::vector<std::string> set{boundaries, "/kernel/h_over_dx=1.3", forms(pair.divergence, pair.gradient), d == 3 ? "/until=0.06" : "/until=0.2"};
                if (viscous) set.push_back(viscosity);
                const int n = d == 3 ? 11 : 21;
                const Profile lattice = final_state(d, n, set);
                for (const char* list : {"frozen", "moving"}) {
                    set.push_back(std::string("/particles/neighbours=") + list);
                    INFO(boundaries << pair.divergence << (viscous ? ", viscous, " : ", ") << list);
                    CHECK(largest_difference(lattice, final_state(d, n, set)) < 1e-12);
                }
            }
    });
}

TEST_CASE("a wall is on the last particles of a lattice that does not fill its box", "[tiers][wall]") {
    for (const char* place : {"on_particles", "half_way"}) {
        std::vector<std::string> set{walls(1, "rigid", place), "/particles/upper=[1.012]", "/until=2"};
        const Case c = sounding(1, 21, set);
        Simulation simulation(c);
        simulation.run();
        CHECK(simulation.summary().energy_final == Approx(simulation.summary().energy_initial).epsilon(1e-12));
        set.push_back("/particles/neighbours=frozen");
        CHECK(largest_difference(simulation.profile(), final_state(1, 21, set)) < 1e-12);
    }
}

TEST_CASE("adjoint pairs keep their energy between walls on a disordered set", "[energy][wall]") {
    for_walls([](int d, const std::string& boundaries) {
        for (const Pair pair : adjoint_pairs)
            for (const char* integrator : {"velocity_verlet", "leapfrog"}) {
                const Summary s = run(sounding(d, d == 3 ? 9 : 21, {boundaries, "/kernel/h_over_dx=1.3", forms(pair.divergence, pair.gradient),
                                                                   "/particles/jitter=0.2", "/particles/seed=7", "/integrator/courant=0.3",
                                                                   std::string("/integrator/type=") + integrator, d == 3 ? "/until=1" : "/until=3"}));
                INFO(boundaries << pair.divergence << ", " << integrator);
                CHECK(s.tier == "frozen");
                CHECK(s.energy_final == Approx(s.energy_initial).epsilon(1e-12));
            }
    });
}

TEST_CASE("a set that moves a little keeps its energy between walls about as one at rest", "[moving][energy][wall]") {
    for (const int d : {1, 2})
        for (const char* type : {"rigid", "soft"})
            for (const char* place : {"on_particles", "half_way"})
                for (const char* gradient : {"sum", "corrected_adjoint"}) {
                    const std::string divergence = *gradient == 's' ? "difference" : "corrected";
                    const auto drift = [&](const std::string& amplitude) {
                        const Summary s = run(scene(periodic_box(d, 21), {walls(d, type, place), forms(divergence, gradient), "/kernel/h_over_dx=1.3",
                                                                         "/initial/p=" + amplitude + "*exp(-((x-0.4)/0.15)^2)",
                                                                         "/particles/motion=lagrangian", "/integrator/courant=0.3", "/until=3"}));
                        CHECK(s.tier == "moving");
                        return std::abs(s.energy_final / s.energy_initial - 1);
                    };
                    INFO(d << "-D, " << type << " " << place << ", " << gradient << ": " << drift("1e-4") << ", " << drift("1e-6"));
                    CHECK(drift("1e-4") < 1e-4);
                    CHECK(drift("1e-6") < 1e-6);
                }
}

TEST_CASE("rigid walls are what a periodic box of twice the length is to symmetric motion, however far particles move", "[moving][wall]") {
    const int n = 12;
    const auto pressures = [](int d, bool folded, const std::string& equations) {
        std::string lower, upper, u, place = "";
        for (int a = 0; a < d; ++a) {
            lower += (a ? "," : "") + Json(folded ? 0 : -n).dump();
            upper += (a ? "," : "") + Json(folded ? n - 1 : n).dump();
            u += (a ? ",\"" : "\"") + std::string(a ? "-0.3" : "0.8") + "*sin(pi*(" + "xy"[a] + "+0.5)/12)\"";
        }
        const Case c = scene(periodic_box(d, 1), {"/particles/dx=1", "/particles/lower=[" + lower + "]", "/particles/upper=[" + upper + "]",
                                                  "/boundaries=[" + (folded ? face("all", "rigid", "half_way") : face("all", "periodic")) + "]",
                                                  equations, viscosity, "/kernel={\"type\":\"wendland_c2\",\"h_over_dx\":1.62}",
                                                  "/initial={\"p\":\"0.1*cos(2*pi*(x+0.5)/12)\",\"u\":[" + u + "]}",
                                                  "/particles/motion=lagrangian", "/integrator/courant=0.2", "/until=5"});
        Simulation simulation(c);
        simulation.run();
        return simulation.profile();
    };
    for (const std::string& equations : {std::string("/equations=lagrangian_acoustics"), current_density})
        for (const int d : {1, 2}) {
            const Profile half = pressures(d, true, equations), whole = pressures(d, false, equations);
            double farthest = 0, worst = 0;
            for (std::size_t i = 0; i < half.p.size(); ++i) {
                const std::size_t column = i % n, row = i / n, other = d == 1 ? column + n : column + n + 2 * n * (row + n);
                farthest = std::max(farthest, std::abs(half.x[0][i] - double(column)));
                worst = std::max({worst, std::abs(half.p[i] - whole.p[other]), std::abs(half.x[0][i] - whole.x[0][other])});
            }
            INFO(d << "-D, " << equations);
            CHECK(farthest > 0.8);    // so that others come within reach of the walls
            CHECK(worst < 1e-10);
        }
}

TEST_CASE("a layered wall is refused where particles are no frozen lattice", "[errors][wall]") {
    for (const char* type : {"absorbing_mur", "soft_fdtd"}) {
        const Case c = sounding(1, 21, {"/boundaries=[" + face("x_max", type) + "]", "/integrator/type=leapfrog", "/particles/jitter=0.1"});
        CHECK_THROWS_WITH(Simulation(c), Catch::Contains("/boundaries/0") && Catch::Contains("Use a frozen lattice"));
    }
}

TEST_CASE("walls closer than an interaction radius are refused", "[errors][wall]") {
    const Case c = sounding(1, 21, {walls(1, "rigid", "on_particles"), "/particles/upper=[1.04]", "/kernel/h_over_dx=10.6", "/particles/neighbours=frozen"});
    CHECK_THROWS_WITH(Simulation(c), Catch::Contains("between walls") && Catch::Contains("Lengthen the box"));
}

TEST_CASE("particles that crowd at a wall beyond all measure stop the run", "[errors][moving][wall]") {
    const Case c = scene(periodic_box(1, 21), {"/boundaries=[" + face("x_min", "rigid", "half_way") + "]", "/kernel/h_over_dx=1.3", "/particles/motion=lagrangian",
                                               R"(/equations={"p":[{"divergence":"u","form":"difference","times":"-1e-9"}],"u":[{"gradient":"p","form":"sum","times":"-1e-9"}]})",
                                               R"(/initial={"u":["-x"]})", "/until=0.95"});
    Simulation simulation(c);
    CHECK_THROWS_WITH(simulation.run(), Catch::Contains("virtual particles") && Catch::Contains("See why particles crowd"));
}
