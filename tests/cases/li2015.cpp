#include "../support/scene.hpp"

#include <fstream>
#include <map>
#include <sstream>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

struct Entry {
    double alpha, beta, propagation, interference;    ///< eps as printed
};

/// Table 2 of Li, Zhang, Zhang (2015), in units of 1e-4.
const std::vector<Entry> table2{{0.00, 0.00, 2.574247, 3.674502}, {0.00, 0.50, 2.571422, 3.674424}, {0.01, 0.50, 2.303623, 3.615698},
                                {0.02, 0.50, 2.177653, 3.580848}, {0.03, 0.50, 2.098490, 3.565303}, {0.04, 0.50, 2.059441, 3.566019},
                                {0.05, 0.50, 2.038529, 3.580722}, {0.06, 0.50, 2.034482, 3.607429}, {0.07, 0.50, 2.039658, 3.644548},
                                {0.08, 0.50, 2.041069, 3.690689}};

Errors errors(const std::string& name, double alpha, double beta, std::vector<std::string> set = {}) {
    set.push_back("/viscosity/alpha=" + std::to_string(alpha));
    set.push_back("/viscosity/beta=" + std::to_string(beta));
    return run(repository_case("li2015/" + name, set)).errors.value();
}

double interference(const std::vector<std::string>& set, double alpha) { return errors("interference", alpha, 0.5, set).rms; }

std::string number(double x) { return Json(x).dump(); }

}    // namespace

TEST_CASE("each entry of Table 2 is within 0.80 to 1.06 of the printed one", "[li2015]") {
    for (const std::string name : {"propagation", "interference"})
        for (const Entry& e : table2) {
            const double printed = 1e-4 * (name == "propagation" ? e.propagation : e.interference);
            const double ratio = errors(name, e.alpha, e.beta).eps / printed;
            INFO(name << " at alpha = " << e.alpha << ", beta = " << e.beta << ": ours over printed " << ratio);
            CHECK(ratio >= 0.80);
            CHECK(ratio <= 1.06);
        }
}

TEST_CASE("beta changes the errors of the first paper by less than half a percent", "[li2015]") {
    for (const std::string name : {"propagation", "interference"})
        CHECK(errors(name, 0.0, 0.5).eps == Approx(errors(name, 0.0, 0.0).eps).epsilon(0.005));
}

TEST_CASE("frozen particles reach the known errors of propagation", "[li2015]") {
    const std::vector<std::string> frozen{"/particles/motion=frozen", "/integrator/type=symplectic_euler"};
    CHECK(errors("propagation", 0.00, 0.5, frozen).eps == Approx(1.79e-4).epsilon(0.02));
    CHECK(errors("propagation", 0.03, 0.5, frozen).eps == Approx(1.76e-4).epsilon(0.02));
    CHECK(errors("propagation", 0.06, 0.5, frozen).eps == Approx(1.78e-4).epsilon(0.02));
}

TEST_CASE("a frozen lattice at h = dx and Courant number one is five times better in far fewer steps", "[li2015]") {
    const std::vector<std::string> better{"/particles/motion=frozen", "/integrator/type=symplectic_euler", "/kernel/h=0.04",
                                          "/integrator/courant=1", "/integrator/courant_length=dx"};
    CHECK(errors("propagation", 0.03, 0.5, better).eps == Approx(0.219e-4).epsilon(0.02));
    CHECK(errors("interference", 0.03, 0.5, better).eps == Approx(0.692e-4).epsilon(0.02));
    CHECK(5 * errors("propagation", 0.03, 0.5, better).eps < errors("propagation", 0.03, 0.5).eps);
    const Case ours = repository_case("li2015/propagation", better), theirs = repository_case("li2015/propagation");
    CHECK(Simulation(theirs).summary().steps > 7 * Simulation(ours).summary().steps);
}

TEST_CASE("staggered finite differences on the first paper's cases reach the known errors", "[li2015]") {
    const std::vector<std::string> half{R"(/method={"type":"fdtd"})", "/integrator/courant=0.5", "/integrator/courant_length=dx"};
    CHECK(errors("propagation", 0, 0, half).eps == Approx(0.124e-4).epsilon(0.02));
    CHECK(errors("interference", 0, 0, half).eps == Approx(0.392e-4).epsilon(0.02));
    auto whole = half;
    whole[1] = "/integrator/courant=1";
    CHECK(errors("propagation", 0, 0, whole).eps < 1e-12);
}

TEST_CASE("Figure 5: the cubic kernel errs less than the quintic and the quintic less than the Gaussian", "[li2015]") {
    const auto error = [](const char* kernel) { return interference({std::string("/kernel/type=") + kernel}, 0.04); };
    const double cubic = error("cubic_spline"), quintic = error("quintic_spline"), gaussian = error("gaussian");
    CHECK(cubic < quintic);
    CHECK(quintic < gaussian);
}

TEST_CASE("Figure 6: the error grows with the spacing", "[li2015]") {
    const auto error = [](double dx) { return interference({"/particles/dx=" + number(dx), "/kernel/h=" + number(3.25 * dx)}, 0.04); };
    const double fine = error(0.04), middle = error(0.06), coarse = error(0.08);
    CHECK(fine < middle);
    CHECK(middle < coarse);
}

TEST_CASE("Figure 7: the Courant number 0.08 is best with the printed leapfrog and the curve is flat with a symplectic one", "[li2015]") {
    std::map<double, double> printed, symplectic;
    for (const double C : {0.02, 0.04, 0.06, 0.08}) {
        printed[C] = interference({"/integrator/courant=" + number(C)}, 0.04);
        symplectic[C] = interference({"/integrator/courant=" + number(C), "/integrator/type=symplectic_euler", "/particles/motion=frozen"}, 0.04);
    }
    for (const double C : {0.02, 0.04, 0.06}) {
        CHECK(printed[0.08] < printed[C]);
        CHECK(symplectic[C] == Approx(symplectic[0.08]).epsilon(0.01));
    }
}
