/// Pulses across an interface on displaced particles, where the dissipation takes its share.
#include "../support/media_pulse.hpp"

using namespace sphonic;
using namespace sphonic::testing;
using namespace sphonic::testing::media;

TEST_CASE("what an interface on a displaced set reflects and lets pass", "[media]") {
    for (const double jitter : {0.1, 0.2})
        for (const Ratio ratio : {Ratio{2, 2}, Ratio{10, 1.5}}) {
            const Passed wave = passed(ratio, {"/particles/jitter=" + number(jitter), "/integrator/courant=0.5", R"(/dissipation={"type":"fourth_order"})"}, 2);
            const double R = wave.reflected - ratio.reflection(), T = wave.transmitted - 1 - ratio.reflection();
            WARN("jitter " << jitter << ", ratio " << ratio.rho << ", " << ratio.c << ": R off by " << R << ", T by " << T << ", energy " << wave.grown);
            CHECK(wave.grown < 1);
            CHECK(std::abs(R) < 1e-3);
            CHECK(std::abs(T) < 1e-3);
        }
}
