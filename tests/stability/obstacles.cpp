/// Walls of obstacles keep the energy in bounds, and the computed step limit holds with them.
#include "../support/cavity.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::string click = "exp(-((x-0.2)^2+(y-0.1)^2)/0.09)";

std::string forms(const std::string& divergence, const std::string& gradient) {
    return R"(/equations={"p":[{"divergence":"u","form":")" + divergence + R"(","times":"-rho0*c0^2"}],"u":[{"gradient":"p","form":")" + gradient +
           R"(","times":"-1/rho0"}]})";
}

/// The same walls around a body in a periodic box.
std::vector<std::string> body_in_a_box(const std::string& wall) {
    return {"/particles/lower=[-2,-2]", "/particles/upper=[2,2]", R"(/boundaries=[{"type":"periodic","face":"all"}])",
            R"(/obstacles=[{"type":"circle","radius":1,"centre":[0.013,0.021],"wall":")" + wall + "\"}]", "/initial/p=exp(-((x-1.5)^2+(y-0.1)^2)/0.09)"};
}

}    // namespace

TEST_CASE("no wall of an obstacle creates sound, inside or outside, in ten thousand steps", "[obstacle]") {
    for (const char* wall : {"rigid", "soft"})
        for (const auto& equations : {forms("corrected", "corrected"), forms("difference", "sum")})
            for (const bool inside : {true, false}) {
                std::vector<std::string> set{equations};
                if (!inside)
                    for (const auto& one : body_in_a_box(wall)) set.push_back(one);
                const Summary s = run(scene(cavity(2, wall, 8, click, 312.5), set));
                INFO(wall << (inside ? " cavity, " : " body, ") << equations);
                CHECK(s.steps == 10000);
                CHECK_FALSE(s.diverged);
                CHECK(s.energy_final < s.energy_initial);
            }
}

TEST_CASE("on disordered sets adjoint forms stay stable between the walls of obstacles", "[obstacle]") {
    for (const char* wall : {"rigid", "soft"})
        for (const auto& equations : {forms("difference", "sum"), forms("corrected", "corrected_adjoint")}) {
            const Summary s = run(scene(cavity(2, wall, 8, click, 62.5), {equations, "/particles/jitter=0.1", "/kernel/h_over_dx=1.3"}));
            INFO(wall << ", " << equations);
            CHECK_FALSE(s.diverged);
            CHECK(s.energy_final < s.energy_initial);
        }
}

TEST_CASE("the computed step limit holds at the walls of obstacles", "[obstacle]") {
    for (const char* wall : {"rigid", "soft"})
        for (const char* integrator : {"leapfrog", "rk4"}) {
            const std::string text = cavity(2, wall, 8, click, 1);
            const Case plain = scene(text);
            const double limit = Simulation(plain).summary().dt_limit * (*integrator == 'r' ? std::sqrt(2.0) : 1);
            const auto at = [&](double share) {
                return run(scene(text, {R"(/integrator={"type":")" + std::string(integrator) + R"(","dt":)" + Json(share * limit).dump() + R"(,"unstable":"allow"})",
                                        "/until=" + Json(2000 * share * limit).dump()}));
            };
            const Summary below = at(0.98);
            INFO(wall << ", " << integrator << ": limit " << below.dt_limit);
            CHECK(below.dt < below.dt_limit);
            CHECK_FALSE(below.diverged);
            CHECK(below.energy_final < 2 * below.energy_initial);
            CHECK(at(1.1).diverged);
        }
}
