/// Interfaces on grids: between points anywhere, and the step that each method bears.
#include "grids.hpp"

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("an interface anywhere between points is right to the second order", "[methods][media]") {
    for (const double place : {0.0, 0.2, 0.35, 0.5, 0.8}) {    // in units of dx, from a point
        const auto error = [&](double dx) {
            const Case c = repository_case("scenes/two_media", {fdtd, "/particles/dx=" + number(dx),
                "/medium/1/region=x > " + number(place * dx), "/reference/interface=[" + number(place * dx) + "]"});
            return run(c).errors->l2;
        };
        const double coarse = error(0.02), fine = error(0.01);
        CAPTURE(place, coarse, fine);
        CHECK(std::log2(coarse / fine) > 1.8);
    }
}

TEST_CASE("the stable step of a grid with media is known", "[methods][media]") {
    struct Ratio {
        double c, rho;
    };
    for (const std::string& method : {fdtd, fdtd_4, kspace})
        for (const Ratio& ratio : {Ratio{2, 2}, Ratio{4.35, 833}}) {
            const std::string medium =
                R"json(/medium=[{"c0":2,"rho0":1.5},{"region":"x > 0.437","c0":)json" + number(2 * ratio.c) + R"json(,"rho0":)json" + number(1.5 * ratio.rho) + "}]";
            const auto outcome = [&](const std::string& step) {
                return run(scene(periodic_box(1, 40), {method, medium, "/initial/p=" + noise(1), "/until=20",
                                                        R"(/integrator={"type":"leapfrog","unstable":"allow",)" + step + "}"}));
            };
            CAPTURE(method, ratio.c);
            const Summary within = outcome("\"safety\":1");
            CHECK_FALSE(within.diverged);
            CHECK(std::abs(within.energy_final / within.energy_initial - 1) < 1e-11);
            if (method == kspace && ratio.c == 2) continue;    // as good as stable beyond it
            const double beyond = method == kspace ? 1.05 : 1.01;    // its limit is by iteration, with a margin
            CHECK(outcome("\"dt\":" + number(beyond * within.dt_limit)).diverged);
        }
}
