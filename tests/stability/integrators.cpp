/// Stable steps of the integrators, held against their amplification polynomials.
#include "../support/scene.hpp"

#include <complex>

#include <sphonic/stability.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

using Complex = std::complex<double>;

Case periodic_line(const std::string& integrator, std::vector<std::string> set = {}) {
    set.push_back("/integrator/type=" + integrator);
    return scene(periodic_box(1, 50), set);
}

double courant(const Case& c, double dt) { return dt * c.medium.c0 / c.box.dx; }

/// log |xi| per step of the line's fastest mode, of frequency c0 / dx for the cubic kernel at h = dx.
struct Amplification {
    const char* integrator;
    double (*growth)(Complex z);
};

const Amplification weak[] = {
    {"forward_euler", [](Complex z) { return std::log(std::abs(1.0 + z)); }},
    {"rk2", [](Complex z) { return std::log(std::abs(1.0 + z + z * z / 2.0)); }},
    {"ab2",
     [](Complex z) {    // xi^2 - (1 + 3z/2) xi + z/2 = 0
         const Complex sum = 1.0 + 1.5 * z, root = std::sqrt(sum * sum - 2.0 * z);
         return std::log(std::max(std::abs(sum + root), std::abs(sum - root)) / 2);
     }},
};

}    // namespace

TEST_CASE("staggered leapfrog has the stable step of symplectic Euler", "[limit]") {
    for (const auto& [ratio, published] : {std::pair{"1", 2.0}, std::pair{"1.3", 2.478}}) {
        const std::vector<std::string> set{std::string("/kernel/h_over_dx=") + ratio};
        INFO("h/dx = " << ratio);
        const Case leapfrog = periodic_line("leapfrog", set), euler = periodic_line("symplectic_euler", set);
        const StepLimit limit = step_limit(leapfrog);
        CHECK_FALSE(limit.weak);
        CHECK(courant(leapfrog, limit.dt) == Approx(published).epsilon(1e-3));
        CHECK(limit.dt == Approx(step_limit(euler).dt).epsilon(1e-12));
    }
}

TEST_CASE("staggered leapfrog keeps the staggered energy from its first step on", "[energy]") {
    const Case c = periodic_line("leapfrog", {"/integrator/courant=1.5", "/initial/p=exp(-((x-0.5)/0.08)^2)"});
    Simulation simulation(c);
    simulation.solver().step();
    const double begin = simulation.solver().energy();
    for (int step = 0; step < 1000; ++step) simulation.solver().step();
    CHECK(simulation.solver().energy() == Approx(begin).epsilon(1e-13));
}

TEST_CASE("an integrator with no stable step gets the one at which the fastest mode grows by e^12 in the run",
          "[limit]") {
    for (const auto& [integrator, growth] : weak)
        for (const double until : {2.5, 25.0}) {
            if (integrator == std::string("forward_euler")) continue;    // refused: the next case
            INFO(integrator << " until " << until << " s");
            const Case c = periodic_line(integrator, {"/until=" + std::to_string(until)});
            const StepLimit limit = step_limit(c);
            CHECK(limit.weak);
            CHECK(until / limit.dt * growth(Complex(0, courant(c, limit.dt))) == Approx(12).margin(1e-3));
        }
}

TEST_CASE("forward Euler gets no step at all and a weak integrator none beyond omega dt = 1", "[limit]") {
    CHECK(step_limit(periodic_line("forward_euler")).dt == 0);
    for (const char* type : {"rk2", "ab2"}) {
        const Case brief = periodic_line(type, {"/until=1e-6"});
        CHECK(courant(brief, step_limit(brief).dt) == Approx(1).epsilon(1e-6));
    }
}

TEST_CASE("the amplification of one step is that of the integrator's polynomial", "[limit]") {
    for (const auto& [integrator, growth] : weak)
        for (const double theta : {0.01, 0.1, 0.5}) {
            INFO(integrator << " at omega dt = " << theta);
            const Case c = periodic_line(integrator);
            const double exact = growth(Complex(0, theta));
            CHECK(std::log(amplification(c, theta * c.box.dx / c.medium.c0)) ==
                  Approx(exact).epsilon(1e-4).margin(1e-13));
        }
}
