#include <algorithm>

#include <sphonic/error.hpp>

#include "../support/scene.hpp"

/// Media with spacings of their own, in one dimension.
using namespace sphonic;
using namespace sphonic::testing;

namespace {

std::string number(double x) { return Json(x).dump(); }

/// Sound in 2 m of a medium and 3 m of one beyond x = 0 of eight times the density, with a spacing `f` times as wide.
struct Pair {
    double f = 1, c = 2, rho = 8, dx = 2 / 40.5;    ///< the interface lies half-way between two particles

    /// `even`: by hand in the coordinate s = x, x/f beyond the interface, in which the spacing is everywhere the first's.
    std::string text(bool even, const std::string& rest) const {
        const double squeeze = even ? f : 1;
        const std::string own = even ? "" : ", \"dx\": " + number(f * dx);
        return R"json({"dimension": 1, "medium": [{"c0": 1, "rho0": 1}, {"region": "x > 0", "c0": )json" + number(c / squeeze) + R"json(, "rho0": )json" + number(rho * squeeze) + own +
               R"json(}], "particles": {"type": "lattice", "dx": )json" + number(dx) + R"json(, "lower": [-2], "upper": [)json" + number(end(even)) + "]}," + rest + "}";
    }
    /// Just beyond the 25th particle of the second medium.
    double end(bool even) const { return 25 * dx * (even ? 1 : f); }
};

const std::string kernel = R"json("kernel": {"type": "cubic_spline", "h_over_dx": 1.2}, "integrator": {"type": "leapfrog", "courant": 0.6}, "until": 2.5,)json";
const std::string rest = kernel + R"json("initial": {"p": "exp(-((x + 1)/0.15)^2)", "u": ["exp(-((x + 1)/0.15)^2)"]})json";

/// One scene by both ways: pressure at the end, particle by particle.
void check_alike(const Pair& pair, const std::string& own, const std::string& by_hand, const std::vector<std::string>& how) {
    const Case graded = scene(pair.text(false, own), how), even = scene(pair.text(true, by_hand), how);
    Simulation one(graded), other(even);
    one.run(), other.run();
    const Profile a = one.profile(), b = other.profile();
    REQUIRE(a.p.size() == b.p.size());
    double loudest = 0, farthest = 0, misplaced = 0;
    for (std::size_t i = 0; i < a.p.size(); ++i) {
        loudest = std::max(loudest, std::abs(b.p[i]));
        farthest = std::max(farthest, std::abs(a.p[i] - b.p[i]));
        misplaced = std::max(misplaced, std::abs(a.x[0][i] - (b.x[0][i] > 0 ? pair.f : 1) * b.x[0][i]));
    }
    CHECK(loudest > 0.2);
    CHECK(farthest <= 1e-11 * loudest);
    CHECK(misplaced <= 1e-12);
    CHECK(std::abs(one.summary().energy_final / other.summary().energy_final - 1) <= 1e-10);
    CHECK(one.summary().dt == Approx(other.summary().dt));
}

const std::vector<std::string> methods{R"(/equations="acoustics")", R"(/equations="band_fitted_acoustics")", R"(/method={"type":"fdtd","order":2})", R"(/method={"type":"fdtd","order":4})"};

}    // namespace

TEST_CASE("a spacing of a medium's own is one for all in another medium", "[own_spacings]") {
    for (const std::string& method : methods)
        for (const double f : {0.4, 2.0, 3.1}) {
            CAPTURE(method, f);
            check_alike({f}, rest, rest, {method, R"(/boundaries=[{"type":"rigid","face":"x"}])"});
        }
}

TEST_CASE("what absorbs is as deep in metres whatever the spacing", "[own_spacings]") {
    const auto layer = [](double thickness) { return rest + R"json(, "boundaries": [{"type": "absorbing_layer", "face": "x_min", "thickness": 0.5}, {"type": "absorbing_layer", "face": "x_max", "thickness": )json" + number(thickness) + "}]"; };
    std::vector<std::string> all = methods;
    all.push_back(R"(/method={"type":"kspace"})");
    for (const std::string& method : all) {
        CAPTURE(method);
        const Pair pair{2};
        check_alike(pair, layer(1.2), layer(0.6), {method});
    }
}

TEST_CASE("a wave that is imposed in metres comes as it would at one spacing", "[own_spacings]") {
    const auto source = [](double at) {
        return kernel + R"json("boundaries": [{"type": "rigid", "face": "x"}], "sources": [{"type": "plane_wave", "omega": 9, "direction": [-1], "phase_origin": [)json" + number(at) + R"json(],
            "region": "x > )json" + number(at) + R"json("}])json";
    };
    const Pair pair{2};
    const double at = 18.3 * pair.f * pair.dx;
    const std::string own = source(at), by_hand = source(at / pair.f);
    for (const std::string& method : methods) {
        CAPTURE(method);
        check_alike(pair, own, by_hand, {method});
    }
}

TEST_CASE("a point supplies as much sound whatever the spacing about it", "[own_spacings]") {
    const auto source = [](const std::string& signal, double at) {
        return kernel + R"json("boundaries": [{"type": "rigid", "face": "x"}], "sources": [{"type": "point", "position": [)json" + number(at) + "], " + signal + "}]";
    };
    const Pair pair{2};
    const double at = 13 * pair.f * pair.dx;
    for (const std::string signal : {R"("signal": "gaussian", "duration": 0.3, "delay": 1)", R"("signal": "sine", "omega": 7, "swell": 1)"})
        for (const std::string& method : methods) {
            CAPTURE(method, signal);
            check_alike(pair, source(signal, at), source(signal, at / pair.f), {method});
        }
}

TEST_CASE("a pulse between media of their own spacings converges at the second order to the exact one", "[own_spacings]") {
    const auto error = [](int n, const std::string& method) {
        const double dx = 3 / (n + 0.5), there = 9 / (std::round(9 / dx * 340 / 1480) + 0.5);
        const Case c = scene(R"json({"dimension": 1, "medium": [{"c0": 340, "rho0": 1.2}, {"region": "x > 0", "c0": 1480, "rho0": 1000, "dx": )json" + number(there) + R"json(}],
            "particles": {"type": "lattice", "dx": )json" + number(dx) + R"json(, "lower": [-3], "upper": [9]}, "boundaries": [{"type": "rigid", "face": "x"}],
            "kernel": {"type": "cubic_spline", "h_over_dx": 1}, "initial": {"p": "exp(-((x + 1)/0.15)^2)", "u": ["exp(-((x + 1)/0.15)^2)/(rho0*c0)"]},
            "integrator": {"type": "leapfrog", "courant": 0.5}, "until": 0.006, "reference": {"type": "two_media", "width": 0.15, "centre": [-1], "interface": [0]}})json", {method});
        Simulation simulation(c);
        simulation.run();
        const Profile now = simulation.profile();
        double squares = 0, all = 0;    // each particle for the spacing it stands in
        for (std::size_t i = 0; i < now.p.size(); ++i) {
            const double share = now.x[0][i] > 0 ? there : dx;
            squares += share * std::pow(now.p[i] - now.exact[i], 2);
            all += share * now.exact[i] * now.exact[i];
        }
        CHECK(simulation.summary().errors->l2 == Approx(std::sqrt(squares / all)).epsilon(1e-9));
        return simulation.summary().errors->l2;
    };
    for (const std::string& method : {methods[0], methods[2]}) {
        CAPTURE(method);
        const double coarse = error(240, method), fine = error(480, method);
        CHECK(fine < 0.02);
        CHECK(std::log2(coarse / fine) == Approx(2).margin(0.15));
    }
}

TEST_CASE("probes are read and bodies of results lie where they are in metres", "[own_spacings]") {
    const Pair pair{2};
    const Case c = scene(pair.text(false, rest + R"json(, "boundaries": [{"type": "rigid", "face": "x"}], "output": {"probes": [[-1], [1.5]], "fields": false})json"), {methods[0]});
    Simulation simulation(c);
    simulation.run();
    CHECK(std::abs(simulation.probes().read_at[0][0] + 1) <= 0.5 * pair.dx);
    CHECK(std::abs(simulation.probes().read_at[1][0] - 1.5) <= 0.5 * pair.f * pair.dx);
    CHECK(std::isfinite(simulation.probes().p[1].back()));
}

TEST_CASE("spacings of media's own are refused where they have no meaning", "[own_spacings]") {
    const std::string text = Pair{2}.text(false, rest);
    const auto refusal = [&](const std::vector<std::string>& set) {
        try {
            scene(text, set);
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    CHECK(refusal({"/medium/0/dx=0.1"}).find("/medium/0/dx: the first medium's spacing is that of the particles") != std::string::npos);
    CHECK(refusal({"/medium/1/dx=0"}).find("/medium/1/dx") != std::string::npos);
    CHECK(refusal({"/medium/1/dx=auto"}).find("/medium/1/dx: \"auto\" is still to be planned") != std::string::npos);
    CHECK(refusal({"/medium/1/dx=1e-12"}).find("of the smallest long. Choose a larger dx") != std::string::npos);
    CHECK(refusal({"/dimension=2", "/particles/lower=[-2,0]", "/particles/upper=[3,1]"}).find("more than one dimension") != std::string::npos);
    CHECK(refusal({"/particles/type=blue_noise"}).find("do not lie on a lattice") != std::string::npos);
    CHECK(refusal({R"(/sources=[{"type":"point","signal":"gaussian","duration":1}])", methods[0]}).find("/sources/0: it is spread over particles of media with different dx") != std::string::npos);
}
