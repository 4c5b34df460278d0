#include "../support/scene.hpp"

#include <complex>

#include <sphonic/error.hpp>
#include <sphonic/stability.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

constexpr double x_axis[3] = {1, 0, 0};

/// c0 dt_limit / dx of a periodic line.
double courant_limit(const std::vector<std::string>& set) {
    const Case c = scene(periodic_box(1, 50), set);
    return step_limit(c).dt * c.medium.c0 / c.box.dx;
}

/// Phase speed over c0 of the longest wave of a periodic line of 64 particles, from a run over ten periods.
double measured_speed(const std::vector<std::string>& set) {
    std::vector<std::string> all{"/until=5", "/integrator/courant=0.05", "/initial/p=sin(2*pi*x)", R"(/initial/u=["sin(2*pi*x)/rho0/c0"])"};
    all.insert(all.end(), set.begin(), set.end());
    const Case c = scene(periodic_box(1, 64), all);
    Simulation simulation(c);
    simulation.run();
    const Profile now = simulation.profile();
    double sine = 0, cosine = 0;
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        sine += now.p[i] * std::sin(2 * testing::pi * now.x[0][i]);
        cosine += now.p[i] * std::cos(2 * testing::pi * now.x[0][i]);
    }
    const double ahead = std::atan2(-cosine, sine);    // p = sin(2 pi x - ahead), beyond ten whole periods
    return 1 + ahead / (2 * testing::pi * 10);
}

}    // namespace

TEST_CASE("a long periodic wave runs at the speed of the symbol", "[symbol]") {
    for (const char* kernel : {"cubic_spline", "quintic_spline", "gaussian"})
        for (const double ratio : {1.0, 1.3, 2.0}) {
            const std::vector<std::string> set{std::string("/kernel/type=") + kernel, "/kernel/h_over_dx=" + std::to_string(ratio)};
            const Case c = scene(periodic_box(1, 64), set);
            const double k = 2 * testing::pi;
            INFO(kernel << " at h/dx = " << ratio);
            CHECK(measured_speed(set) == Approx(dispersion(c, k, x_axis) / k).margin(1e-4));
        }
}

TEST_CASE("the wave-speed floor of the cubic kernel is that of the symbol's slope at zero", "[symbol]") {
    const auto error = [](double ratio) {
        return long_wave_speed(scene(periodic_box(1, 50), {"/kernel/h_over_dx=" + std::to_string(ratio)}), x_axis) - 1;
    };
    CHECK(error(1.0) == Approx(0).margin(1e-9));
    CHECK(error(1.3) == Approx(2.24e-2).margin(5e-5));
    CHECK(error(2.0) == Approx(0).margin(1e-9));
    CHECK(error(3.25) == Approx(1.65e-3).margin(5e-6));
}

TEST_CASE("the stable step is the integrator's limit over the symbol's maximum", "[limit]") {
    for (const char* type : {"symplectic_euler", "velocity_verlet"}) {
        INFO(type);
        const std::string integrator = std::string("/integrator/type=") + type;
        CHECK(courant_limit({integrator}) == Approx(2).epsilon(1e-4));
        CHECK(courant_limit({integrator, "/kernel/h_over_dx=1.3"}) == Approx(2.478).epsilon(1e-3));
    }
    CHECK(courant_limit({"/integrator/type=rk4"}) == Approx(2 * std::sqrt(2.0)).epsilon(1e-3));
    CHECK(courant_limit({"/integrator/type=rk4", "/kernel/h_over_dx=1.3"}) == Approx(3.504).epsilon(1e-3));
    CHECK(courant_limit({"/integrator/type=symplectic_euler", "/kernel/h_over_dx=1.3", R"(/viscosity={"type":"monaghan","alpha":0.06,"beta":0.5})"}) ==
          Approx(2.398).epsilon(1e-3));
}

TEST_CASE("runs are stable just below the limit and diverge just beyond it", "[limit]") {
    const std::vector<std::string> noise{"/initial/p=sin(pi*x/dx/2)*cos(6*pi*x)", "/until=40", R"(/integrator/unstable=allow)"};
    for (const char* type : {"symplectic_euler", "velocity_verlet", "rk4"}) {
        const double limit = courant_limit({std::string("/integrator/type=") + type});
        const auto energy_ratio = [&](double fraction) {
            auto set = noise;
            set.insert(set.end(), {std::string("/integrator/type=") + type, "/integrator/courant=" + std::to_string(fraction * limit)});
            const Summary s = run(scene(periodic_box(1, 40), set));
            return s.diverged ? std::numeric_limits<double>::infinity() : std::abs(s.energy_final / s.energy_initial);
        };
        INFO(type);
        CHECK(energy_ratio(0.99) < 1.01);
        CHECK_FALSE(energy_ratio(1.01) < 1e3);
    }
}

TEST_CASE("the printed leapfrog has no limit of its own and gets the step of a bounded growth", "[limit]") {
    const auto limit = [](const char* until) {
        return step_limit(scene(periodic_box(1, 50), {"/integrator/type=leapfrog_li2015", std::string("/until=") + until}));
    };
    const StepLimit brief = limit("0.25"), lasting = limit("25");
    CHECK(brief.weak);
    CHECK(lasting.dt < brief.dt);
    // AB2: xi^2 - (1 + 3z/2) xi + z/2 = 0 with z = i theta, theta = c0 dt / dx at the symbol's maximum
    const Case c = scene(periodic_box(1, 50), {});
    const std::complex<double> z(0, lasting.dt * c.medium.c0 / c.box.dx), sum = 1.0 + 1.5 * z;
    const std::complex<double> xi = 0.5 * (sum + std::sqrt(sum * sum - 2.0 * z));
    CHECK(25 / lasting.dt * std::log(std::abs(xi)) == Approx(12).epsilon(0.001));
}

TEST_CASE("a step beyond the limit is refused with the limit named", "[limit]") {
    try {
        run(scene(periodic_box(1, 50), {"/integrator/courant=2.1"}));
        FAIL("it ran");
    } catch (const Error& e) {
        CHECK(e.fault == Fault::input);
        const std::string what = e.what();
        CHECK(what.find("/integrator/courant") != std::string::npos);
        CHECK(what.find("beyond the stable limit") != std::string::npos);
        CHECK(what.find("c0 dt/dx = 2)") != std::string::npos);
    }
}
