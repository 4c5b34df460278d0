/// The whole spectrum of sets with fitted weights.
#include "../support/cloud.hpp"

#include <sphonic/stability.hpp>

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("no mode of a cloud with fitted weights grows, whichever way particles lie", "[cloud][spectrum]") {
    for (int seed = 1; seed <= 5; ++seed) {
        const Case c = scene(periodic_box(2, 24), with(cloud(0.2, seed), {"/integrator/type=leapfrog", "/integrator/courant=0.5"}));
        double rightmost = 0, fastest = 0;
        for (const auto& z : eigenvalues(assembled(c))) rightmost = std::max(rightmost, z.real()), fastest = std::max(fastest, std::abs(z));
        const double unit = c0 / c.box.dx;
        WARN("seed " << seed << ": largest Re " << rightmost / unit << ", largest modulus " << fastest / unit << " c0/dx");
        CHECK(rightmost <= 1e-8 * unit);
        CHECK(fastest > 0.5 * unit);
    }
}
