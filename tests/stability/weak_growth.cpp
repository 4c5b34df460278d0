/// Integrators that grow at any step: by how much, over long runs.
#include "../support/stability.hpp"

#include <complex>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

using Complex = std::complex<double>;

double rk2(double theta) { return std::log(std::abs(1.0 + Complex(0, theta) + Complex(0, theta) * Complex(0, theta) / 2.0)); }
/// xi^2 - (1 + 3z/2) xi + z/2 = 0, z = i theta.
double ab2(double theta) {
    const Complex z(0, theta), sum = 1.0 + 1.5 * z, root = std::sqrt(sum * sum - 2.0 * z);
    return std::log(std::max(std::abs(sum + root), std::abs(sum - root)) / 2);
}

struct Weak {
    const char* integrator;
    double (*growth)(double theta);    ///< ln |xi| per step, theta = omega dt
};
const Weak all_weak[] = {{"ab2", ab2}, {"rk2", rk2}, {"leapfrog_li2015", ab2}};

/// The largest frequency that a kernel h = dx leaves on the waves of a periodic line or square of n a side: c0 |sin k dx|/dx by axis.
double fastest(const Case& c, int n) {
    double largest = 0;
    for (int m = 0; m < n; ++m) largest = std::max(largest, std::sin(2 * testing::pi * m / n));
    return c.medium.c0 / c.box.dx * largest;
}

}    // namespace

TEST_CASE("weak integrators grow over a long run as their polynomials say, to 3 %", "[weak]") {
    for (const Weak& weak : all_weak)
        for (const int n : {50, 31})
            for (const double courant : {0.2, 0.4, 0.7}) {
                const Case c = quiet_box(1, n, {kernel("cubic_spline", 1), integrator(weak.integrator)});
                const double dt = courant * c.box.dx / c.medium.c0, exact = weak.growth(fastest(c, n) * dt);
                const long steps = std::min(40000L, long(6 / exact));
                const GrowthFinding found = find_growth(c, dt, steps, {});
                INFO(weak.integrator << ", " << n << " particles, c0 dt/dx = " << courant << ", " << steps << " steps");
                CHECK(found.measured == Approx(exact).epsilon(0.03));
                CHECK(found.predicted == Approx(exact).epsilon(1e-6));
            }
}

TEST_CASE("weak growth on squares and on disordered sets is that of their fastest motion", "[weak]") {
    for (const Weak& weak : all_weak)
        for (const double jitter : {0.0, 0.2}) {
            const Case c = quiet_box(2, 12, {kernel("cubic_spline", 1.3), integrator(weak.integrator), "/particles/jitter=" + Json(jitter).dump()});
            const double omega = StepTheory(c).limit().frequency, dt = 0.5 / omega;
            const GrowthFinding found = find_growth(c, dt, 300, {});
            INFO(weak.integrator << ", jitter " << jitter);
            CHECK(found.predicted == Approx(weak.growth(0.5)).epsilon(1e-6));
            CHECK(found.measured == Approx(weak.growth(0.5)).epsilon(0.03));
        }
}

TEST_CASE("the step at which a weak integrator's worst mode grows by e is told, and what it grows by at the run's own", "[weak]") {
    for (const Weak& weak : all_weak) {
        const Case c = quiet_box(1, 50, {kernel("cubic_spline", 1), integrator(weak.integrator, R"(,"courant":0.1)"), "/until=5"});
        const Summary prepared = Simulation(c).summary();
        const double omega = c.medium.c0 / c.box.dx;
        INFO(weak.integrator);
        CHECK(c.until / prepared.dt_mild * weak.growth(omega * prepared.dt_mild) == Approx(1).epsilon(1e-3));
        CHECK(prepared.growth == Approx(double(prepared.steps) * weak.growth(omega * prepared.dt)).epsilon(1e-3));
        CHECK(prepared.dt_mild < prepared.dt_limit);
    }
    CHECK(Simulation(quiet_box(1, 50, {integrator("leapfrog")})).summary().dt_mild == 0);
}

TEST_CASE("the limit of a weak integrator is measured where it is predicted, to 1 %", "[weak][bisection]") {
    for (const Weak& weak : all_weak) {
        const Case c = quiet_box(1, 50, {kernel("cubic_spline", 1.3), integrator(weak.integrator), "/until=5"});
        const StabilityFinding found = find_stability(c, {});
        INFO(weak.integrator);
        CHECK(found.predicted.weak);
        CHECK(found.measured.dt == Approx(found.predicted.dt).epsilon(0.01));
    }
    const Case euler = quiet_box(1, 50, {integrator("forward_euler")});
    const StabilityFinding found = find_stability(euler, {});
    CHECK(found.predicted.dt == 0);
    CHECK(found.measured.dt == 0);
}
