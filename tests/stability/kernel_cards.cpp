/// Report cards of kernels, against what is known in closed form.
#include <sphonic/kernel_card.hpp>

#include "../support/scene.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const KernelCard& cubic_spline() {
    static const KernelCard card = kernel_card(registry(), "cubic_spline");
    return card;
}

const KernelRow& row_of(const KernelCard& card, int dimension, double h_over_dx) {
    for (const KernelRow& r : card.rows)
        if (r.dimension == dimension && r.h_over_dx == h_over_dx) return r;
    throw std::out_of_range("no such row");
}

}    // namespace

TEST_CASE("the card of the cubic spline on a line at h = dx is that of central differences", "[card]") {
    // two neighbours with the weight 1/(2 dx): omega = c0/dx sin(k dx)
    const KernelRow& row = row_of(cubic_spline(), 1, 1);
    CHECK(row.neighbours == 2);
    CHECK(row.speed_error == Approx(0).margin(1e-12));
    CHECK(row.cutoff_ppw == Approx(4));
    CHECK(row.courant_dx.at("leapfrog") == Approx(2).epsilon(1e-6));
    CHECK(row.courant_dx.at("velocity_verlet") == Approx(2).epsilon(1e-6));
    CHECK(row.courant_dx.at("rk4") == Approx(2 * std::sqrt(2)).epsilon(1e-5));
    CHECK(row.courant_dx.count("ab2") == 0);
    for (const auto& [points, error] : {std::pair{*row.ppw_1_percent, 0.01}, {*row.ppw_01_percent, 0.001}}) {
        const double k = 2 * testing::pi / points;    // points are found to 1e-4, and the error goes as their square
        CHECK(2 * std::sin(10 * testing::pi * (1 - std::sin(k) / k)) == Approx(error).epsilon(5e-4));
    }
    CHECK(*row.work() == Approx(std::pow(*row.ppw_1_percent, 2)).epsilon(1e-6));
}

TEST_CASE("a wrong speed of long waves is the kernel's discrete moment", "[card]") {
    // -sum_j dx x_j W'(x_j), W' = -2 q + 3/2 q^2, then -(2 - q)^2/2, over h^2
    const double h = 1.3, near = 1 / h, far = 2 / h;
    const double moment = 2 * (1 * (2 * near - 1.5 * near * near) + 2 * 0.5 * std::pow(2 - far, 2)) / (h * h);
    CHECK(row_of(cubic_spline(), 1, 1.3).speed_error == Approx(moment - 1).epsilon(1e-9));
}

TEST_CASE("cards hold kernels to what they claim, and know which ones pair", "[card]") {
    for (const std::string& name : registry().names("kernel")) {
        INFO(name);
        const KernelCard card = kernel_card(registry(), name);
        for (const KernelLaw& law : card.laws) {
            INFO(law.what << " in " << law.dimension << "-D: " << law.value);
            const bool optional = law.what == "is nowhere negative" || law.what == "falls with distance";
            CHECK((law.holds || (optional && name == "super_gaussian")));
        }
        for (const KernelTransform& t : card.transforms) {
            CHECK(t.value.front() == Approx(1));
            if (name.substr(0, 8) == "wendland") CHECK(t.least == 0);
            if (name == "cubic_spline" && t.dimension > 1) CHECK(t.least < 0);
        }
        CHECK(card.recommended.size() == card.dimensions.size());
        for (const KernelRow& best : card.recommended)
            for (const KernelRow& row : card.rows)
                if (row.dimension == best.dimension && row.work()) CHECK(*best.work() <= *row.work() * (1 + 1e-9));
    }
}

TEST_CASE("kernels are ranked by the work for one per cent", "[card]") {
    const auto ranking = rank_kernels(registry(), {"cubic_spline", "super_gaussian"}, 2);
    REQUIRE(ranking.size() == 2);
    CHECK(ranking[0].first == "super_gaussian");    // of fourth order
    CHECK(*ranking[0].second.work() < *ranking[1].second.work());
}
