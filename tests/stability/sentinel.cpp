/// What a run that diverges tells: when, where, how fast, why, and what to do.
#include "../support/stability.hpp"

#include <regex>

using namespace sphonic;
using namespace sphonic::testing;
using Catch::Matchers::Contains;

namespace {

const std::string allowed = "/integrator/unstable=allow";

Case failure(const std::string& name, std::vector<std::string> set = {}) {
    set.push_back(allowed);
    return repository_case("failures/" + name, set);
}

Summary diverging(const Case& c) {
    Simulation simulation(c);
    simulation.run();
    REQUIRE(simulation.summary().diverged);
    CHECK(simulation.last_good().t == simulation.summary().last_good_t);
    for (const double p : simulation.last_good().p) REQUIRE(std::isfinite(p));
    return simulation.summary();
}

/// The number that stands before `unit` in a message.
double told(const std::string& message, const std::string& before, const std::string& after) {
    std::smatch found;
    INFO(message);
    REQUIRE(std::regex_search(message, found, std::regex(before + "([-+.e0-9]+)" + after)));
    return std::stod(found[1]);
}

}    // namespace

TEST_CASE("a run that diverges names the likely cause and its remedy", "[sentinel]") {
    const auto how = [](const std::string& name, const std::vector<std::string>& set = {}) { return diverging(failure(name, set)).diverged_how; };
    CHECK_THAT(how("step_too_large"), Contains("the step is 1.01 times the stable limit. Take 5.88") && Contains("(c0 dt/dx = 2) or less"));
    CHECK_THAT(how("viscous_step"), Contains("times the stable limit"));
    CHECK_THAT(how("weak_growth"), Contains("the integrator grows slowly at any step") && Contains("or leapfrog or rk4"));
    CHECK_THAT(how("disorder"), Contains("not adjoint on disordered particles") && Contains("fourth_order dissipation"));
    CHECK_THAT(how("contrast"), Contains("not adjoint where the media meet") && Contains("the form impedance"));
    CHECK_THAT(how("no_ghosts"), Contains("beside a face without virtual particles") && Contains("rigid or soft walls"));
    CHECK_THAT(how("mur_in_2d"), Contains("the wall at x_max remembers") && Contains("absorbing_layer"));
}

TEST_CASE("growth is told as fast as it is", "[sentinel]") {
    for (const double courant : {2.2, 2.6, 3.5}) {    // the worst wave: ln |xi| = arcosh(s^2/2 - 1), s = c0 dt/dx in units of 2/s_max = 1
        const Summary s = diverging(failure("step_too_large", {R"(/integrator={"type":"leapfrog","unstable":"allow","courant":)" + Json(courant).dump() + "}"}));
        const double exact = std::acosh(courant * courant / 2 - 1);
        INFO(s.diverged_how);
        CHECK(told(s.diverged_how, "growing by e\\^", " a step") == Approx(exact).epsilon(0.1));
        CHECK(told(s.diverged_how, " a step, ", " per second") == Approx(exact / s.dt).epsilon(0.1));
    }
}

TEST_CASE("a run that diverges is stopped within a few steps of the onset", "[sentinel]") {
    for (const char* method : {"particles", "fdtd"}) {
        const Case c = scene(periodic_box(2, 200), {R"(/method={"type":")" + std::string(method) + "\"}", integrator("leapfrog", R"(,"courant":3)"), "/until=3",
                                                 "/initial/p=exp(-40*((x-0.5)^2+(y-0.4)^2))"});
        Simulation simulation(c);
        simulation.run();
        const Summary& s = simulation.summary();
        INFO(method << ": " << s.diverged_how);
        CHECK(s.diverged);
        CHECK((s.t - s.last_good_t) / s.dt < 30);    // four of them to measure growth
    }
}

TEST_CASE("a message of divergence names the particle and its place", "[sentinel]") {
    const Case c = failure("no_ghosts");
    const std::string how = diverging(c).diverged_how;
    const double number = told(how, "the pressure of particle ", " at "), x = told(how, " at \\(", "\\) m");
    CHECK((number < 4 || number > 76));    // at the ends, which have no walls
    CHECK(x == Approx(number * c.box.dx));
}
