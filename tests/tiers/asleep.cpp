/// What no sound has reached is not stepped, and what can no longer matter: nothing that is asked for changes.
#include "sound.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

struct End {
    Summary summary;
    Profile profile;
    ProbeRecord probes;
};

/// On one thread, unless the case asks for more.
End end(Case c) {
    if (c.threads == 0) c.threads = 1;
    Simulation simulation(c);
    simulation.run();
    REQUIRE_FALSE(simulation.summary().diverged);
    return {simulation.summary(), simulation.profile(), simulation.probes()};
}

/// A pulse of a few spacings at a share `at` of a box of n spacings to a side, for so many steps.
std::string pulse(int dimension, int n, int steps, double at = 0.4) {
    std::string lower, upper, r2;
    for (int a = 0; a < dimension; ++a) {
        const std::string comma = a > 0 ? "," : "";
        lower += comma + "0";
        upper += comma + std::to_string(n);
        r2 += (a > 0 ? "+(" : "(") + std::string(1, "xyz"[a]) + "-" + std::to_string(std::round(at * n)) + ")^2";
    }
    return R"json({"dimension": )json" + std::to_string(dimension) + R"json(, "medium": {"c0": 2, "rho0": 1.5},
        "particles": {"type": "lattice", "dx": 1, "lower": [)json" + lower + R"json(], "upper": [)json" + upper + R"json(]},
        "kernel": {"type": "cubic_spline", "h_over_dx": 1.3}, "equations": "linear_acoustics",
        "initial": {"p": "exp(-()json" + r2 + R"json()/4)"}, "integrator": {"type": "leapfrog", "dt": 0.2}, "until": )json" + Json(0.2 * steps).dump() + "}";
}

double largest_of_difference(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

double largest(const std::vector<double>& values) {
    double most = 0;
    for (const double v : values) most = std::max(most, std::abs(v));
    return most;
}

/// Runs a case with and without sleep: all values agree, and the bound is kept. The share of particle-steps. Tails carry less than is
/// heard some way ahead of the sound, so that only a compact pulse wakes all that sound reaches.
double share(const std::string& text, std::vector<std::string> set, bool compact = true) {
    const End asleep = end(scene(text, set));
    set.push_back("/active=all");
    const End awake = end(scene(text, set));
    const Summary& s = asleep.summary;
    CHECK(awake.summary.particle_steps == double(awake.summary.particles) * double(awake.summary.steps));
    CHECK(s.all_because.empty());
    CHECK(largest_difference(awake.profile, asleep.profile) <= 1e-12 * largest(awake.profile.p));
    CHECK(s.asleep_error <= 1e-12);
    if (compact) CHECK(s.ideal_particle_steps <= s.particle_steps);
    return s.particle_steps / awake.summary.particle_steps;
}

double share(int dimension, const std::vector<std::string>& set) {
    return share(pulse(dimension, dimension == 1 ? 1600 : dimension == 2 ? 120 : 60, dimension == 3 ? 12 : 40), set);
}

std::string walls(const std::string& type) { return "/boundaries=[" + face("all", type) + "]"; }
std::string integrator(const std::string& type) { return R"(/integrator={"type":")" + type + R"(","dt":0.1})"; }

}    // namespace

TEST_CASE("in every dimension, with any walls, sleep changes nothing and spares work", "[asleep]") {
    for (const int d : {1, 2, 3})
        for (const char* type : {"free", "periodic", "rigid", "soft"}) {
            INFO(d << "-D, " << type);
            CHECK(share(d, {walls(type)}) <= 1);
        }
}

TEST_CASE("the wake is as wide as a whole step reaches, wherever in a tile the sound begins", "[asleep]") {
    for (int x = 100; x < 132; ++x) {
        INFO("one particle, at " << x);
        for (const char* type : {"leapfrog", "rk4"})
            CHECK(share(pulse(1, 1600, 10), {integrator(type), "/initial/p=exp(-1e4*(x-" + std::to_string(x) + ")^2)"}) < 0.7);
    }
}

TEST_CASE("walls see the sound that comes to them", "[asleep]") {
    for (const int d : {1, 2})
        for (const char* type : {"free", "periodic", "rigid", "soft", "absorbing_mur", "soft_fdtd"}) {
            INFO(d << "-D, " << type);
            const int n = d == 1 ? 2400 : 150;
            CHECK(share(pulse(d, n, n, 0.1), {walls(type)}) < 1);
        }
    const std::string layer = R"(/boundaries=[{"type":"absorbing_layer","face":"all","thickness":12,"attenuation":60}])";
    CHECK(share(pulse(2, 150, 100, 0.15), {layer}) < 1);
    CHECK(share(pulse(1, 1600, 1200, 0.1), {R"(/boundaries=[{"type":"impedance","face":"all","impedance":6}])"}) < 1);
}

TEST_CASE("the tails of a pulse stand still until there is sound to speak of, and nothing changes", "[asleep]") {
    for (const std::string equations : {"linear_acoustics", "acoustics", "band_fitted_acoustics"}) {
        const std::vector<std::string> how{"/equations=" + equations, walls("rigid")};
        const auto from = [&](const std::string& p) { return std::vector{how[0], how[1], "/initial={\"p\":\"" + p + "\"}"}; };
        CHECK(share(pulse(1, 2400, 1000), from("exp(-((x - 800)/60)^2)"), false) < 0.7);    // which is not zero anywhere
        CHECK(share(pulse(2, 160, 60), from("exp(-((x - 64)^2 + (y - 64)^2)/36)"), false) < 0.8);
    }
    for (const char* type : {"symplectic_euler", "velocity_verlet", "rk4", "ab2", "rk2", "leapfrog_li2015"}) {    // with stages and with histories
        INFO(type);
        CHECK(share(pulse(1, 2400, 600), {integrator(type), walls("rigid"), R"json(/initial={"p":"exp(-((x - 800)/60)^2)"})json"}, false) < 0.7);
    }
    for (const char* type : {"soft", "soft_fdtd", "absorbing_mur"}) {    // that see the tail
        INFO(type);
        CHECK(share(pulse(1, 2400, 1000), {walls(type), R"json(/initial={"p":"exp(-((x - 480)/60)^2)"})json"}, false) < 0.8);
    }
}

TEST_CASE("little that could sleep is not looked for", "[asleep]") {
    const End small = end(scene(pulse(1, 150, 150, 0.1)));
    CHECK_THAT(small.summary.all_because, Catch::Contains("longer than it could spare"));
    CHECK(small.summary.particle_steps == double(small.summary.particles) * double(small.summary.steps));
}

TEST_CASE("with every integrator a tile that wakes has the history that it needs", "[asleep]") {
    for (const char* type : {"leapfrog", "symplectic_euler", "velocity_verlet", "rk4", "ab2", "rk2", "leapfrog_li2015"})
        for (const int d : {1, 2}) {
            INFO(type << ", " << d << "-D");
            CHECK(share(d, {integrator(type)}) < 0.9);
        }
}

TEST_CASE("sources, viscosity, media and every form sleep as well", "[asleep]") {
    const std::string imposed = R"(/sources=[{"type":"plane_wave","region":"x < 20","amplitude":1,"omega":0.5}])", silent = R"(/initial/p="0")";
    const std::string point = R"(/sources=[{"type":"point","flow":1,"omega":0.5,"position":[50,50]}])";
    CHECK(share(1, {imposed}) < 0.7);
    CHECK(share(2, {point, silent}) < 0.7);
    CHECK(share(2, {imposed, viscosity, silent}) < 0.8);
    CHECK(share(1, {viscosity, integrator("leapfrog_li2015")}) < 0.8);
    CHECK(share(2, {R"(/medium=[{"c0":2,"rho0":1.5},{"c0":3,"rho0":400,"region":"x + y/3 > 70"}])", "/equations=acoustics", "/integrator/dt=0.1", "/integrator/unstable=allow"}) < 0.8);
    for (const char* preset : {"acoustics", "corrected_acoustics", "band_fitted_acoustics", "lagrangian_acoustics"}) {
        INFO(preset);
        CHECK(share(2, {std::string("/equations=") + preset, walls("periodic")}) < 1);
    }
}

TEST_CASE("particles that can no longer matter to probes are dropped without a trace", "[asleep]") {
    for (const int d : {1, 2, 3})
        for (const char* type : {"leapfrog", "rk4", "velocity_verlet"}) {
            const std::string probes = d == 1 ? "[[180],[10]]" : d == 2 ? "[[60,50]]" : "[[30,24,24]]";
            const std::string text = pulse(d, d == 1 ? 1600 : d == 2 ? 120 : 60, d == 3 ? 14 : 60);
            std::vector<std::string> set{integrator(type), walls("rigid"), "/output/probes=" + probes};
            const End whole = end(scene(text, set));
            set.push_back("/output/fields=false");
            const End some = end(scene(text, set));
            INFO(d << "-D, " << type);
            for (std::size_t k = 0; k < whole.probes.p.size(); ++k) CHECK(largest_of_difference(whole.probes.p[k], some.probes.p[k]) < 1e-14);
            CHECK(some.summary.particle_steps < whole.summary.particle_steps);
            CHECK(some.summary.ideal_particle_steps <= some.summary.particle_steps);
        }
}

TEST_CASE("errors in a region ask for no more than the region", "[asleep]") {
    const std::vector<std::string> set{R"(/reference={"type":"pulse","amplitude":1,"width":2,"region":"r < 5"})", "/particles/lower=[-60,-60]", "/particles/upper=[60,60]",
                                       R"json(/initial/p=exp(-(r/2)^2))json"};
    std::vector<std::string> without = set;
    without.push_back("/output/fields=false");
    const Summary whole = run(scene(pulse(2, 120, 60), set)), some = run(scene(pulse(2, 120, 60), without));
    CHECK(some.errors->l2 == Approx(whole.errors->l2).epsilon(1e-12));
    CHECK(some.particle_steps < whole.particle_steps);
}

TEST_CASE("where sleep is not proved all is stepped, and the summary says why", "[asleep]") {
    const auto why = [](const std::vector<std::string>& set) { return run(scene(pulse(1, 100, 4), set)).all_because; };
    CHECK(why({"/particles/neighbours=frozen"}) == "only lattices have parts that sleep");
    CHECK(why({R"(/integrator={"type":"leapfrog","courant":8,"unstable":"allow"})", "/until=100"}) == "the step is beyond the stable limit");
    CHECK(why({R"(/equations={"rho":[{"divergence":"u","form":"difference","times":"-rho"}],"p":[{"divergence":"u","form":"difference","times":"-rho0*c0^2"}],
        "u":[{"gradient":"rho","form":"difference","times":"-c0^2/rho0"}]})"}) == "rho is not zero at rest, and u follows its derivative");
    CHECK_THROWS_WITH(scene(pulse(1, 100, 4), {"/output/fields=false"}), Catch::Contains("/output/fields") && Catch::Contains("Give probes or a reference"));
}

TEST_CASE("asleep or not, the same bits for any number of threads", "[asleep][threads]") {
    for (const int d : {1, 2, 3}) {
        const auto on = [d](int threads) {
            Case c = scene(pulse(d, d == 3 ? 40 : 120, 12), {walls("rigid")});
            c.threads = threads;
            return end(std::move(c));
        };
        const End one = on(1);
        for (const int threads : {2, 5}) {
            const End other = on(threads);
            CHECK(one.profile.p == other.profile.p);
            CHECK(one.summary.particle_steps == other.summary.particle_steps);
            CHECK(one.summary.asleep_error == other.summary.asleep_error);
        }
    }
}

TEST_CASE("the first paper's propagation takes 1.6 times less work, of 1.9 that are possible", "[asleep]") {
    const Summary s = run(repository_case("li2015/propagation", {"/particles/motion=frozen", "/particles/neighbours=lattice"}));
    const double nominal = double(s.particles) * double(s.steps);
    CHECK(nominal / s.ideal_particle_steps == Approx(1.9).margin(0.05));
    CHECK(nominal / s.particle_steps >= 1.6);
    CHECK(s.asleep_error < 1e-12);
}

TEST_CASE("a pulse in a box ten times as large as it ends saves most of what can be saved", "[asleep]") {
    const Summary s = end(scene(pulse(3, 160, 12, 0.5), {})).summary;
    const double nominal = double(s.particles) * double(s.steps);
    CHECK(nominal / s.particle_steps >= 1.6);
    CHECK(nominal - s.particle_steps >= 0.6 * (nominal - s.ideal_particle_steps));
}
