#include "../support/gradients.hpp"

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("the corrected gradient is of second order on a lattice and of first on disorder", "[gradient]") {
    const auto order = [](double jitter) { return std::log2(gradient_error(48, jitter, "corrected") / gradient_error(96, jitter, "corrected")); };
    CHECK(order(0) == Approx(2).margin(0.01));
    CHECK(order(0.2) >= 0.95);
}

TEST_CASE("plain sums do not converge on disorder, nor do those corrected along each axis on its own", "[gradient]") {
    const double jitter = 0.2;
    CHECK(gradient_error(96, jitter, "difference") > 0.9 * gradient_error(48, jitter, "difference"));
    CHECK(diagonal_gradient_error(96, jitter) > 0.9 * diagonal_gradient_error(48, jitter));
    CHECK(diagonal_gradient_error(48, 0) == Approx(gradient_error(48, 0, "corrected")).epsilon(1e-3));    // on a lattice they are the same
}
