/// What grows in a set at any step: by a small set of the same make, before a run.
#include "../support/stability.hpp"

using namespace sphonic;
using namespace sphonic::testing;
using Catch::Matchers::Contains;

namespace {

Case failure(const std::string& name, std::vector<std::string> set = {}) {
    set.push_back("/integrator/unstable=allow");
    return repository_case("failures/" + name, set);
}

/// ln of the amplitude's growth per second in the second half of its way up by e^60, where nothing but the worst motion is left.
double measured_rate(const Case& c) {
    Simulation simulation(c);
    abi::Solver& solver = simulation.solver();
    const auto loudness = [&] {
        const abi::Snapshot shot = solver.snapshot();
        double squares = 0;
        for (int i = 0; i < shot.points.n; ++i) squares += shot.p[i] * shot.p[i];
        return 0.5 * std::log(squares);
    };
    const double begin = loudness();
    double middle = 0;
    for (int step = 0; step < 40000; ++step) {
        solver.step();
        const double now = loudness() - begin;
        if (middle == 0 && now > 30) middle = solver.time();
        if (now > 60) return 30 / (solver.time() - middle);
    }
    return 0;
}

std::string refusal(const Case& c) {
    try {
        Simulation{c};
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

}    // namespace

TEST_CASE("the rate at which a set grows is known from a small one of the same make", "[set_growth]") {
    struct Row {
        const char* name;
        std::vector<std::string> set;
        double exact = 0.35;    ///< disorder's worst place is another in each set
    };
    for (const Row& row : {Row{"disorder", {}}, Row{"disorder", {"/particles/upper=[1.6,1.6]", "/particles/seed=7"}}, Row{"contrast", {}},
                           Row{"contrast", {"/particles/dx=0.03125"}}, Row{"no_ghosts", {}, 0.01}, Row{"no_ghosts", {"/particles/dx=0.0125", "/integrator/courant=0.4"}, 0.01},
                           Row{"mur_in_2d", {}}, Row{"mur_in_2d", {"/particles/upper=[2,1]"}}}) {
        const Case c = failure(row.name, row.set);
        const double measured = measured_rate(c);
        const SetGrowth found = set_growth(c, asked_step(c, 0));
        INFO(row.name << ", " << c.particles << " particles: " << found.basis);
        CHECK(found.rate == Approx(measured).epsilon(row.exact));
    }
}

TEST_CASE("nothing is said to grow in sets that keep their energy, are damped, or are held by sources", "[set_growth]") {
    const auto quiet = [](const Case& c) {
        INFO(c.title);
        const SetGrowth found = set_growth(c, asked_step(c, 1e-5));
        CHECK(found.rate * c.until < 1);
        CHECK_FALSE(found.dt_limit);
    };
    quiet(failure("disorder", {R"(/dissipation={"type":"fourth_order"})"}));
    quiet(failure("disorder", {"/equations=linear_acoustics"}));
    quiet(failure("disorder", {"/equations=band_fitted_acoustics"}));
    quiet(failure("contrast", {"/equations=acoustics"}));
    quiet(failure("no_ghosts", {R"(/boundaries=[{"type":"soft","face":"x"}])"}));
    quiet(failure("mur_in_2d", {R"(/boundaries/2={"type":"impedance","face":"x_max","impedance":408})"}));
    for (const char* name : {"scenes/jittered_box", "scenes/circle_scattering_2d", "scenes/corner_room_2d", "scenes/two_media_2d", "scenes/pulse_3d_absorbed",
                             "zhang2017/duct_rigid_2d", "zhang2017/duct_absorbing_2d", "li2015/propagation"})
        quiet(repository_case(name));
}

TEST_CASE("a run's limit is that of walls that remember", "[set_growth][walls]") {
    const std::string mur = R"(/boundaries=[{"face":"all","type":"absorbing_mur"}])";
    const Case c = quiet_box(1, 120, {kernel("cubic_spline", 1.3), mur, R"(/integrator={"type":"leapfrog","safety":0.99})"});
    const Case same = quiet_box(1, 120, {kernel("cubic_spline", 1.3), mur, integrator("leapfrog")});
    const Summary s = Simulation(c).summary();
    CHECK(s.dt_limit == Approx(StepTheory(same).limit().dt).epsilon(0.05));
    CHECK(s.dt_limit < 0.9 * step_limit(c).dt);
    CHECK(s.dt <= s.dt_limit);
}

TEST_CASE("what grows by more than e is told, by more than e^12 refused unless the case allows it", "[set_growth]") {
    const auto disorder = [](const std::string& until, const std::string& unstable) {
        return repository_case("failures/disorder", {"/until=" + until, "/integrator/unstable=" + unstable});
    };
    CHECK(Simulation(disorder("0.0005", "refuse")).summary().warnings.empty());
    const Case told = disorder("0.005", "refuse");
    const Summary s = Simulation(told).summary();
    REQUIRE(s.warnings.size() == 1);
    CHECK_THAT(s.warnings[0], Contains("not adjoint on disordered particles") && Contains("by e in 1"));
    CHECK(s.growth == Approx(s.growth_rate * told.until));
    CHECK_THAT(refusal(disorder("0.02", "refuse")), Contains("/equations: the forms") && Contains("\"allow\""));
    CHECK(refusal(disorder("0.02", "allow")).empty());
}
