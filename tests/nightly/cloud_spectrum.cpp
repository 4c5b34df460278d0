/// The whole spectrum of sets with fitted weights.
#include "../support/cloud.hpp"

#include <sphonic/stability.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

/// Of the whole operator in units of c0/dx: the largest real part and the largest modulus.
struct Extent {
    double rightmost = 0, farthest = 0;
};
Extent extent(int seed, double damping) {
    const std::string form = R"("form": {"type": "band_fitted", "damping": )" + number(damping) + "}";
    const Case c = scene(periodic_box(2, 24), with(cloud(0.2, seed), {"/integrator/type=leapfrog", "/integrator/courant=0.5",
        R"(/equations={"p": [{"divergence": "u", )" + form + R"(, "times": "-rho0*c0^2"}], "u": [{"gradient": "p", )" + form + R"(, "times": "-1/rho0"}]})"}));
    Extent found;
    for (const auto& z : eigenvalues(assembled(c))) {
        found.rightmost = std::max(found.rightmost, z.real() * c.box.dx / c0);
        found.farthest = std::max(found.farthest, std::abs(z) * c.box.dx / c0);
    }
    return found;
}

}    // namespace

TEST_CASE("no mode of a cloud with fitted weights grows, whichever way particles lie, and without damping some do", "[cloud][spectrum]") {
    for (int seed = 1; seed <= 5; ++seed) {
        const Extent damped = extent(seed, 1);
        WARN("seed " << seed << ": largest Re " << damped.rightmost << ", largest modulus " << damped.farthest << " c0/dx");
        CHECK(damped.rightmost <= 1e-8);
        CHECK(damped.farthest > 0.5);
    }
    CHECK(extent(1, 0).rightmost > 0.01);
}
