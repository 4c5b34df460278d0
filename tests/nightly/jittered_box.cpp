#include "../support/jittered_box.hpp"

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("corrected forms with dissipation keep order two up to 192 disordered particles a side", "[dissipation]") {
    const double coarse = jittered_box_error(24, 0.2), middle = jittered_box_error(96, 0.2), fine = jittered_box_error(192, 0.2);
    CHECK(fine == Approx(0.00167).epsilon(0.1));    // of a prototype with other random displacements
    CHECK(std::log2(middle / fine) >= 1.9);
    CHECK(std::log2(coarse / fine) >= 3 * 1.9);
    CHECK(std::log2(jittered_box_error(96) / jittered_box_error(192)) >= 1.9);
}

TEST_CASE("disordered boxes with dissipation of the usual strength last for fifty passages at every size", "[dissipation]") {
    for (const int n : {48, 96})
        for (const int seed : {1, 2}) {
            const Summary s = run(repository_case("scenes/jittered_box", {"/particles/dx=" + Json(1.0 / n).dump(), "/particles/seed=" + std::to_string(seed),
                                                                         "/initial/p=cos(2*pi*x)*cos(pi*y)+cos(1e5*x)*sin(7.77e4*y)", "/until=" + Json(50. / 340).dump()}));
            INFO("n = " << n << ", seed " << seed);
            CHECK_FALSE(s.diverged);
            CHECK(s.energy_final < s.energy_initial);
        }
}
