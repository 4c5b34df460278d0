#include "sound.hpp"

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("stencil, kept pairs and moving list agree to round-off on a frozen lattice", "[tiers]") {
    for (const int d : {1, 2, 3})
        for (const char* boundary : {"free", "periodic"})
            for (const char* form : {"sum", "symmetric", "difference"})
                for (const bool viscous : {false, true}) {
                    std::vector<std::string> set{
                        std::string(R"(/boundaries=[{"type":")") + boundary + R"(","face":"all"}])", "/kernel/h_over_dx=1.3",
                        forms("difference", form)};
                    if (viscous) set.push_back(viscosity);
                    set.push_back(d == 3 ? "/until=0.06" : "/until=0.2");
                    const int n = d == 3 ? 11 : 21;
                    const Profile lattice = final_state(d, n, set);
                    INFO(d << "-D, " << boundary << ", " << form << (viscous ? ", viscous" : ""));
                    for (const char* list : {"frozen", "moving"}) {
                        set.push_back(std::string("/particles/neighbours=") + list);
                        CHECK(largest_difference(lattice, final_state(d, n, set)) < 1e-12);
                    }
                }
}

TEST_CASE("stencils of any reach and rows of any length agree with kept pairs", "[tiers]") {
    for (const int d : {2, 3})
        for (const char* h : {"0.9", "1.3", "1.7", "2.2"})
            for (const int n : d == 2 ? std::vector<int>{6, 15, 23, 38} : std::vector<int>{6, 8}) {
                std::vector<std::string> set{std::string("/kernel/h_over_dx=") + h, "/boundaries=[]", "/initial/p=sin(3*x+1)*cos(2*y)", "/until=0.1"};
                const Profile lattice = final_state(d, n, set);
                set.push_back("/particles/neighbours=frozen");
                INFO(d << "-D, h/dx = " << h << ", " << n << " to a row");
                CHECK(largest_difference(lattice, final_state(d, n, set)) < 1e-12);
            }
}

TEST_CASE("equations with a current density agree between stencil and list where densities hardly change", "[tiers]") {
    const std::vector<std::string> set{"/equations=lagrangian_acoustics", "/kernel/h_over_dx=1.3", "/initial={\"p\":\"1e-6*sin(2*pi*x)\"}"};
    const Case frozen = scene(periodic_box(1, 30), set);
    auto other = set;
    other.push_back("/particles/neighbours=moving");
    const Case listed = scene(periodic_box(1, 30), other);
    Simulation a(frozen), b(listed);
    a.run();
    b.run();
    CHECK(largest_difference(a.profile(), b.profile()) < 1e-12);    // differs by amplitude^2 / (rho0 c0^2)
}

TEST_CASE("the staggered energy of an adjoint pair is constant to round-off", "[energy]") {
    for (const char* integrator : {"symplectic_euler", "velocity_verlet", "leapfrog"})
        for (const int d : {1, 2, 3})
            for (const char* boundary : {"free", "periodic"}) {
                std::vector<std::string> set = sound(d);
                set.insert(set.end(), {std::string("/integrator/type=") + integrator, "/kernel/h_over_dx=1.3",
                                       std::string(R"(/boundaries=[{"type":")") + boundary + R"(","face":"all"}])", "/until=0.5"});
                const Summary s = run(scene(periodic_box(d, d == 3 ? 11 : 21), set));
                INFO(integrator << ", " << d << "-D, " << boundary);
                CHECK(s.energy_final == Approx(s.energy_initial).epsilon(1e-12));
            }
}

TEST_CASE("the adjoint pair conserves its energy on a disordered set too", "[energy]") {
    for (const int d : {1, 2, 3}) {
        std::vector<std::string> set = sound(d);
        set.insert(set.end(), {"/particles/jitter=0.2", "/particles/seed=7", "/integrator={\"type\":\"symplectic_euler\"}",
                               "/kernel/h_over_dx=1.3", "/until=0.5"});
        const Summary s = run(scene(periodic_box(d, d == 3 ? 11 : 21), set));
        INFO(d << "-D");
        CHECK(s.tier == "frozen");
        CHECK(s.energy_final == Approx(s.energy_initial).epsilon(1e-12));
    }
}

TEST_CASE("the limit of equations with a current density is that of linear acoustics at rest", "[energy]") {
    const auto limit = [](const std::string& equations, double c0) {
        const std::vector<std::string> set{"/equations=" + equations, "/particles/jitter=0.2", "/kernel/h_over_dx=1.3", "/initial={}",
                                           "/medium/c0=" + std::to_string(c0), "/until=" + std::to_string(0.1 / c0)};
        return Simulation(scene(periodic_box(2, 15), set)).summary().dt_limit;
    };
    for (const double c0 : {1.0, 340.0}) CHECK(limit("lagrangian_acoustics", c0) == Approx(limit("linear_acoustics", c0)).epsilon(1e-6));
}

TEST_CASE("the computed limit of a disordered set holds: stable below it and lost beyond", "[energy]") {
    const std::string face = GENERATE(as<std::string>(), "periodic", "rigid", "soft");
    INFO(face);
    const auto at = [&](double fraction) {
        const std::vector<std::string> set{"/particles/jitter=0.2", "/kernel/h_over_dx=1.3", "/initial/p=cos(1000*x)*sin(777*y)",
                                           "/boundaries=[{\"type\":\"" + face + "\",\"face\":\"all\"}]"};
        const Case probe = scene(periodic_box(2, 21), set);
        auto all = set;
        all.insert(all.end(), {"/integrator={\"type\":\"symplectic_euler\",\"unstable\":\"allow\",\"dt\":" +
                                   Json(fraction * Simulation(probe).summary().dt_limit).dump() + "}", "/until=40"});
        return run(scene(periodic_box(2, 21), all));
    };
    const Summary below = at(0.99);
    CHECK_FALSE(below.diverged);
    CHECK(below.energy_final < 1.0001 * below.energy_initial);
    CHECK(at(1.05).diverged);
}

TEST_CASE("a jittered set leaves the particles on its faces there", "[arrangement]") {
    const Case c = scene(periodic_box(2, 10), {R"(/boundaries=[])", "/particles/jitter=0.3"});
    const Profile p = Simulation(c).profile();
    long on_face = 0, moved = 0;
    for (std::size_t i = 0; i < p.p.size(); ++i) {
        on_face += p.x[0][i] == 0;
        moved += std::abs(p.x[0][i] * 10 - std::round(p.x[0][i] * 10)) > 1e-9;
        CHECK(p.x[0][i] >= 0);
        CHECK(p.x[0][i] <= 1 + 1e-12);
    }
    CHECK(on_face == 11);
    CHECK(moved == 99);
}

TEST_CASE("viscosity takes energy away and never gives any", "[energy]") {
    for (const int d : {1, 2}) {
        std::vector<std::string> set = sound(d);
        set.insert(set.end(), {viscosity, "/kernel/h_over_dx=1.3", "/until=0.5"});
        const Summary s = run(scene(periodic_box(d, 21), set));
        CHECK(s.energy_final < 0.99 * s.energy_initial);
        CHECK(s.energy_final > 0);
    }
}

TEST_CASE("a moving lattice with a uniform velocity carries its sound along", "[moving]") {
    // Galilean invariance: all particles drift at 0.3 m/s, their pressures are those of the set at rest
    const auto pressures = [](const char* drift) {
        const Case c = scene(periodic_box(1, 40), {"/particles/motion=lagrangian", "/kernel/h_over_dx=1.3", "/initial/p=1e-4*sin(2*pi*x)",
                                                   std::string("/initial/u=[\"") + drift + "\"]"});
        Simulation simulation(c);
        simulation.run();
        return simulation.profile();
    };
    const Profile still = pressures("0"), drifting = pressures("0.3");
    CHECK(largest_difference(still, drifting) < 1e-13);
    CHECK(drifting.x[0][0] == Approx(0.3 * 0.25).epsilon(1e-3));
}

TEST_CASE("a case run from its resolved form gives the same bits", "[resolved]") {
    const Case first = repository_case("li2015/propagation", {"/until=0.004"});
    const Case second = load_case(*first.resolved, first.file, registry());
    Simulation a(first), b(second);
    a.run();
    b.run();
    CHECK(a.profile().p == b.profile().p);
    CHECK(*first.resolved == *second.resolved);
}
