/// What no gate has the time for: that fitted weights keep clouds stable for a million steps, and whichever way particles lie.
#include "../support/cloud.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::string leapfrog = "/integrator/type=leapfrog";

}    // namespace

TEST_CASE("a cloud with fitted weights lets no noise grow in a million steps", "[cloud]") {
    CHECK(growth(2, 16, 1e6, 0.5, with(cloud(0.2, 1), {leapfrog})) < 1.1);
}

TEST_CASE("clouds of many seeds let no noise grow", "[cloud]") {
    for (int seed = 1; seed <= 5; ++seed) {
        INFO("seed " << seed);
        CHECK(growth(1, 48, 2e5, 0.5, with(cloud(0.2, seed), {leapfrog})) < 1.1);
        CHECK(growth(2, 24, 1e5, 0.5, with(cloud(0.2, seed), {leapfrog})) < 1.1);
        CHECK(growth(3, 10, 1e4, 0.4, with(cloud(0.2, seed), {leapfrog})) < 1.1);
    }
}
