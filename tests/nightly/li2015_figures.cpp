#include "../support/scene.hpp"

#include <map>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::vector<double> alphas{0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08};

std::string number(double x) { return Json(x).dump(); }

/// rms error of interference at each alpha.
std::map<double, double> curve(std::vector<std::string> set) {
    std::map<double, double> errors;
    for (const double alpha : alphas) {
        auto all = set;
        all.push_back("/viscosity/alpha=" + number(alpha));
        errors[alpha] = run(repository_case("li2015/interference", all)).errors.value().rms;
    }
    return errors;
}

double minimum_at(const std::map<double, double>& curve) {
    return std::min_element(curve.begin(), curve.end(), [](auto& a, auto& b) { return a.second < b.second; })->first;
}

}    // namespace

TEST_CASE("Figure 5: cubic below quintic below Gaussian at every alpha, with minima between .03 and .06", "[li2015]") {
    const auto cubic = curve({}), quintic = curve({"/kernel/type=quintic_spline"}), gaussian = curve({"/kernel/type=gaussian"});
    for (const double alpha : alphas) {
        INFO("alpha = " << alpha);
        CHECK(cubic.at(alpha) < quintic.at(alpha));
        CHECK(quintic.at(alpha) < gaussian.at(alpha));
    }
    for (const auto& one : {cubic, quintic, gaussian}) {
        CHECK(minimum_at(one) >= 0.03);
        CHECK(minimum_at(one) <= 0.06);
    }
}

TEST_CASE("Figure 6: the error grows with the spacing at every alpha", "[li2015]") {
    const auto at = [](double dx) { return curve({"/particles/dx=" + number(dx), "/kernel/h=" + number(3.25 * dx)}); };
    const auto fine = at(0.04), middle = at(0.06), coarse = at(0.08);
    for (const double alpha : alphas) {
        CHECK(fine.at(alpha) < middle.at(alpha));
        CHECK(middle.at(alpha) < coarse.at(alpha));
    }
}

TEST_CASE("Figure 7: the Courant number 0.08 is best at every alpha with the printed leapfrog", "[li2015]") {
    const auto best = curve({"/integrator/courant=0.08"});
    for (const double C : {0.02, 0.04, 0.06}) {
        const auto other = curve({"/integrator/courant=" + number(C)});
        for (const double alpha : alphas) CHECK(best.at(alpha) < other.at(alpha));
    }
}
