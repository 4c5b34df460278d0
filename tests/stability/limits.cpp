/// Limits by theory against limits that runs from noise show.
#include "../support/stability.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::string adjoint =
    R"(/equations={"p":[{"divergence":"u","form":"corrected","times":"-rho0*c0^2"}],"u":[{"gradient":"p","form":"corrected_adjoint","times":"-1/rho0"}]})";
const std::string corrected = "/equations=corrected_acoustics";

std::string monaghan(double alpha) { return R"(/viscosity={"type":"monaghan","alpha":)" + Json(alpha).dump() + R"(,"beta":0.5})"; }
std::string dissipation(double alpha) { return R"(/dissipation={"type":"fourth_order","alpha":)" + Json(alpha).dump() + "}"; }

double ratio(const StabilityFinding& found) { return found.measured.dt / found.predicted.dt; }

}    // namespace

TEST_CASE("the predicted limit of a periodic lattice is the measured one to 1 %", "[bisection]") {
    struct Row {
        int dimension, n;
        const char* kernel;
        double h;
        const char* integrator;
    };
    for (const Row& row : {Row{1, 40, "cubic_spline", 1, "leapfrog"}, Row{1, 39, "quintic_spline", 1.3, "rk4"}, Row{1, 40, "gaussian", 3.25, "velocity_verlet"},
                           Row{2, 16, "cubic_spline", 1.3, "symplectic_euler"}, Row{2, 15, "wendland_c2", 2, "leapfrog"}, Row{2, 16, "wendland_c4", 2, "rk4"},
                           Row{3, 8, "cubic_spline", 1.3, "leapfrog"}, Row{3, 8, "wendland_c6", 1.3, "rk4"}}) {
        const Case c = quiet_box(row.dimension, row.n, {kernel(row.kernel, row.h), integrator(row.integrator)});
        INFO(row.kernel << ", h/dx = " << row.h << ", " << row.integrator << ", " << row.n << " a side in " << row.dimension << "-D");
        CHECK(ratio(find_stability(c, brief)) == Approx(1).margin(0.01));
    }
}

TEST_CASE("a box bears more than its lattice where the worst wave does not fit into it", "[bisection]") {
    const Case c = quiet_box(1, 7, {kernel("cubic_spline", 1), integrator("leapfrog")});    // 2 at k dx = pi/2; k dx = 4 pi/7 fits
    const double fits = 2 / std::sin(4 * testing::pi / 7);
    const StabilityFinding found = find_stability(c, brief);
    CHECK(courant_dx(c, found.predicted.dt) == Approx(fits).epsilon(1e-6));
    CHECK(courant_dx(c, found.measured.dt) == Approx(fits).epsilon(0.01));
    CHECK(courant_dx(c, step_limit(c).dt) == Approx(2).epsilon(1e-6));
}

TEST_CASE("with Monaghan's viscosity the limit is that of its linear part at half strength, between always on and none", "[bisection][viscosity]") {
    for (const auto& [dimension, n, h, type] : {std::tuple{1, 40, 1.3, "leapfrog"}, {1, 40, 3.25, "symplectic_euler"}, {2, 16, 1.3, "leapfrog"}, {1, 40, 1.3, "rk4"}}) {
        const Case c = quiet_box(dimension, n, {kernel("cubic_spline", h), integrator(type), monaghan(0.06)});
        const StabilityFinding found = find_stability(c, brief);
        INFO("h/dx = " << h << ", " << type << " in " << dimension << "-D");
        CHECK(ratio(found) == Approx(1).margin(0.01));
        REQUIRE(found.inviscid);
        const auto [least, most] = std::minmax(*found.always_on, *found.inviscid);    // RK4 bears more with damping
        CHECK(most > 1.005 * least);
        CHECK(found.measured.dt < most * (1 + found.measured.precision));
        CHECK(found.measured.dt > least * (1 - found.measured.precision));
        CHECK(step_limit(c).dt < least * 1.005);
    }
}

TEST_CASE("the predicted limit of a disordered set is the measured one to 5 %", "[bisection][disorder]") {
    for (const auto& [fraction, forms, damping] :
         {std::tuple{0.2, std::string("/equations=linear_acoustics"), 0.0}, {0.2, adjoint, 0.0}, {0.2, corrected, 0.2}, {0.1, corrected, 0.5}})
        for (const char* type : {"leapfrog", "rk4"})
            for (const int n : {10, 18}) {    // all eigenvalues, and a Krylov space's
                std::vector<std::string> set{kernel("cubic_spline", 1.3), integrator(type), "/particles/jitter=" + Json(fraction).dump(), forms};
                if (damping > 0) set.push_back(dissipation(damping));
                const Case c = quiet_box(2, n, set);
                const StabilityFinding found = find_stability(c, brief);
                INFO(forms << ", jitter " << fraction << ", dissipation " << damping << ", " << type << ", " << found.basis);
                CHECK(ratio(found) == Approx(1).margin(0.05));
            }
}

TEST_CASE("corrected forms on a disordered set have no stable step, by theory and by runs", "[bisection][disorder]") {
    for (const int n : {10, 18}) {
        const Case c = quiet_box(2, n, {kernel("cubic_spline", 1.3), integrator("leapfrog"), "/particles/jitter=0.2", corrected});
        const StabilityFinding found = find_stability(c, {.steps = 3000});
        INFO(found.basis);
        CHECK(found.predicted.dt == 0);
        CHECK(found.measured.dt == 0);
    }
}

TEST_CASE("the predicted limit between walls is the measured one to 5 %, with what the walls remember", "[bisection][walls]") {
    struct Row {
        int dimension;
        const char *wall, *forms;
    };
    for (const Row& row : {Row{1, "rigid", "linear"}, Row{1, "soft", "corrected"}, Row{2, "rigid", "corrected"}, Row{2, "soft", "linear"}, Row{2, "free", "linear"},
                           Row{1, "soft_fdtd", "linear"}, Row{1, "absorbing_mur", "linear"}, Row{1, "absorbing_mur", "corrected"}}) {
        const Case c = quiet_box(row.dimension, row.dimension == 1 ? 40 : 16,
                                 {kernel("cubic_spline", 1.3), integrator("leapfrog"), faces(row.wall), std::string("/equations=") + row.forms + "_acoustics"});
        INFO(row.wall << ", " << row.forms << " in " << row.dimension << "-D");
        CHECK(ratio(find_stability(c, {.steps = 4000, .precision = 5e-3})) == Approx(1).margin(0.05));
    }
}

TEST_CASE("Mur's condition lowers the limit below that of the lattice", "[bisection][walls]") {
    const std::vector<std::string> set{kernel("cubic_spline", 1.3), integrator("leapfrog"), faces("absorbing_mur")};
    const Case c = quiet_box(1, 40, set);
    CHECK(StepTheory(c).limit().dt < 0.9 * step_limit(c).dt);
}

TEST_CASE("finite differences become unstable where they say", "[bisection]") {
    for (int dimension = 1; dimension <= 2; ++dimension) {
        const Case c = quiet_box(dimension, 20, {R"(/method={"type":"fdtd"})"});
        const StabilityFinding found = find_stability(c, {.steps = 1500});
        CHECK(courant_dx(c, found.predicted.dt) == Approx(1 / std::sqrt(dimension)).epsilon(1e-9));
        CHECK(ratio(found) == Approx(1).margin(0.01));
    }
}
