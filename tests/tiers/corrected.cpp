/// Corrected forms on sets with a neighbour list: kept weights and matrices computed at every evaluation.
#include "sound.hpp"

#include <sphonic/error.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::string jittered = "/particles/jitter=0.2", wide = "/kernel/h_over_dx=1.3", moving = "/particles/neighbours=moving";

Profile after(int dimension, const std::vector<std::string>& set) {
    const Case c = scene(periodic_box(dimension, 21), set);
    Simulation simulation(c);
    simulation.run();
    return simulation.profile();
}

}    // namespace

TEST_CASE("corrected forms agree between kept weights and matrices computed anew", "[tiers][corrected]") {
    for (const int d : {1, 2, 3})
        for (const char* boundaries : {"free", "periodic", "rigid"})
            for (const auto& equations : {forms("corrected", "corrected_adjoint"), forms("corrected_adjoint", "impedance")}) {
                const int n = d == 3 ? 7 : 21;
                std::vector<std::string> set{"/boundaries=[" + face("all", boundaries) + "]", equations, wide, jittered, viscosity,
                                             R"(/integrator={"type":"velocity_verlet","courant":0.3})", d == 3 ? "/until=0.1" : "/until=0.2"};
                const Profile kept = final_state(d, n, set);
                set.push_back(moving);
                INFO(d << "-D, " << boundaries << ", " << equations);
                CHECK(largest_difference(kept, final_state(d, n, set)) < 1e-12);
            }
}

TEST_CASE("corrected and plain gradients of one variable add up on a moving list", "[tiers][corrected]") {
    const std::string both = R"(/equations={"p":[{"divergence":"u","form":"corrected","times":"-rho0*c0^2"}],
        "u":[{"gradient":"p","form":"difference","times":"-0.25/rho0"},{"gradient":"p","form":"corrected","times":"-0.5/rho0"},
             {"gradient":"p","form":"corrected_adjoint","times":"-0.25/rho0"}]})";
    for (const int d : {1, 2, 3}) {
        std::vector<std::string> set{both, wide, jittered, "/until=0.05", "/integrator/courant=0.3"};
        const Profile kept = final_state(d, d == 3 ? 9 : 21, set);
        set.push_back(moving);
        CHECK(largest_difference(kept, final_state(d, d == 3 ? 9 : 21, set)) < 1e-12);
    }
}

TEST_CASE("corrected forms are exact for linear fields on a moving list that simply ends", "[corrected]") {
    const double dt = 1e-3, K = 1.5 * 2 * 2;
    const auto after_steps = [&](const std::string& form, const std::string& initial, int steps) {
        const Case c = scene(periodic_box(2, 11), {"/boundaries=[]", forms("corrected", form), wide, jittered, moving, "/initial=" + initial,
                                                   R"(/integrator={"type":"symplectic_euler","dt":0.001})", "/until=" + Json(steps * dt).dump()});
        Simulation simulation(c);
        simulation.run();
        return simulation.profile();
    };
    for (const char* form : {"corrected", "impedance"}) {
        const Profile uniform = after_steps(form, R"({"p":"3*x-2*y+7"})", 5);    // the same acceleration everywhere leaves p alone
        for (std::size_t i = 0; i < uniform.p.size(); ++i)
            CHECK(uniform.p[i] == Approx(3 * uniform.x[0][i] - 2 * uniform.x[1][i] + 7).epsilon(1e-12));
        const Profile expanding = after_steps(form, R"({"u":["2*x+y","3*y-x"]})", 1);
        for (const double p : expanding.p) CHECK(p == Approx(-5 * K * dt).epsilon(1e-12));
    }
}

TEST_CASE("corrected equations with a current density agree with those at rest where densities hardly change", "[corrected]") {
    const std::string small = "/initial={\"p\":\"1e-6*sin(2*pi*x)\"}";
    for (const int d : {1, 2}) {
        const Profile rest = after(d, {forms("corrected", "corrected_adjoint"), wide, small});
        const Profile carried = after(d, {current_density, wide, small, "/particles/motion=lagrangian"});
        CHECK(largest_difference(rest, carried) < 1e-11);    // differs by amplitude^2 / (rho0 c0^2)
    }
}

TEST_CASE("corrections weigh neighbours by their current volumes", "[corrected]") {
    const double c0 = 2, rho0 = 1.5, dt = 1e-3;
    const Profile now = after(2, {current_density, "/boundaries=[]", wide, jittered, moving, R"-(/initial={"p":"2*sin(9*x)","u":["2*x+y","3*y-x"]})-",
                                  R"(/integrator={"type":"forward_euler","unstable":"allow","dt":0.001})", "/until=0.001"});
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        const double drho = 2 * std::sin(9 * now.x[0][i]) / (c0 * c0);    // the divergence of u is 5 everywhere
        CHECK(now.p[i] == Approx(c0 * c0 * (drho - (rho0 + drho) * 5 * dt)).margin(1e-12));
    }
}

TEST_CASE("a neighbourhood without a gradient is refused by particle, place and neighbours", "[errors][corrected]") {
    std::string message[2];
    for (const int list : {0, 1}) {
        const Case c = scene(periodic_box(1, 200), {"/boundaries=[]", forms("corrected", "corrected"), "/kernel/h_over_dx=0.55", "/particles/jitter=0.45",
                                                    std::string("/particles/neighbours=") + (list ? "moving" : "frozen")});
        try {
            Simulation simulation(c);
        } catch (const Error& e) {
            message[list] = e.what();
        }
        CHECK_THAT(message[list], Catch::Matches(".*/particles: the 0 neighbours of particle [0-9]+ at \\(0.[0-9]+\\) m do not determine a gradient.*Choose a larger h.*"));
    }
    CHECK(message[0] == message[1]);
}
