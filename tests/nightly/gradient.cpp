#include "../support/gradients.hpp"

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("the corrected gradient converges to 384 particles a side, others stall", "[nightly]") {
    CHECK(std::log2(gradient_error(192, 0, "corrected") / gradient_error(384, 0, "corrected")) == Approx(2).margin(0.01));
    for (const double jitter : {0.1, 0.2}) {
        CAPTURE(jitter);
        const double full = gradient_error(384, jitter, "corrected"), diagonal = diagonal_gradient_error(384, jitter);
        CHECK(std::log2(gradient_error(192, jitter, "corrected") / full) >= 0.95);
        CHECK(diagonal > 0.9 * diagonal_gradient_error(192, jitter));
        CHECK(diagonal > 3 * full);
        CHECK(gradient_error(384, jitter, "difference") > 0.9 * gradient_error(192, jitter, "difference"));
    }
}
