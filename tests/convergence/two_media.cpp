#include "../support/scene.hpp"

/// Pulses from one medium into another, against R = (Z2 - Z1)/(Z2 + Z1) and T = 2 Z2/(Z2 + Z1).
using namespace sphonic;
using namespace sphonic::testing;

namespace {

/// rho and c of the second medium over the first.
struct Ratio {
    double rho, c;

    double impedance() const { return rho * c; }
    double reflection() const { return (impedance() - 1) / (impedance() + 1); }
};

constexpr double dx = 0.01, sigma = 16 * dx, start = -1.25, interface = 0.5 * dx, until = 2.25;

double pulse(double s) { return std::exp(-s * s / (2 * sigma * sigma)); }
std::string number(double x) { return Json(x).dump(); }

/// A Gaussian pulse of p and u that sets out rightwards in the first medium, along x in any dimension.
std::string pulse_into(const Ratio& ratio, int dimension = 1) {
    const bool plane = dimension == 2;
    const std::string f = "exp(-(x - " + number(start) + ")^2/(2*" + number(sigma) + "^2))", far = number(std::ceil(5 + 5 * ratio.c));
    return R"json({"dimension": )json" + std::to_string(dimension) + R"json(,
        "medium": [{"c0": 1, "rho0": 1}, {"region": "x > 0.5*dx", "c0": )json" + number(ratio.c) + R"json(, "rho0": )json" + number(ratio.rho) + R"json(}],
        "particles": {"type": "lattice", "dx": 0.01, "lower": [-5)json" + (plane ? ", 0" : "") + R"json(], "upper": [)json" + far + (plane ? ", 0.2" : "") + R"json(]},
        "boundaries": [{"type": "periodic", "face": "all"}], "kernel": {"type": "cubic_spline", "h_over_dx": 1.2}, "equations": "acoustics",
        "initial": {"p": ")json" + f + R"json(", "u": [")json" + f + '"' + (plane ? ", \"0\"" : "") + R"json(]},
        "integrator": {"type": "leapfrog", "courant": 0.7}, "until": )json" + number(until) + "}";
}

/// What comes back and what goes on, by projection of the last state on the exact pulses.
struct Passed {
    double reflected, transmitted, grown;    ///< the last: energy over that at the start
};
Passed passed(const Ratio& ratio, const std::vector<std::string>& set, int dimension = 1) {
    const Case c = scene(pulse_into(ratio, dimension), set);
    Simulation simulation(c);
    simulation.run();
    const Profile now = simulation.profile();
    double back = 0, back_norm = 0, on = 0, on_norm = 0;
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        const double s = now.x[0][i] - interface, travelled = until + start - interface;
        if (std::abs(now.x[0][i]) > 4.5 * std::max(1.0, ratio.c)) continue;    // the box is periodic
        double& sum = s < 0 ? back : on;
        double& norm = s < 0 ? back_norm : on_norm;
        const double shape = s < 0 ? pulse(-s - travelled) : pulse(s / ratio.c - travelled);
        sum += shape * now.p[i];
        norm += shape * shape;
    }
    return {back / back_norm, on / on_norm, simulation.summary().energy_final / simulation.summary().energy_initial};
}

const Ratio modest{2, 2}, heavy{10, 1.5}, air_to_water{1000 / 1.2, 1480. / 340}, water_to_air{1.2 / 1000, 340. / 1480};
const std::string band_fitted = R"(/equations="band_fitted_acoustics")";
const std::string frozen = "/particles/neighbours=frozen";
const std::string fdtd = R"(/method={"type":"fdtd"})", fdtd_4 = R"(/method={"type":"fdtd","order":4})", kspace = R"(/method={"type":"kspace"})";    // with wider stencils

}    // namespace

TEST_CASE("what an interface reflects and lets pass", "[media]") {
    for (const std::string& how : {std::string("/output={}"), band_fitted, frozen, fdtd})
        for (const Ratio& ratio : {modest, heavy, air_to_water}) {
            CAPTURE(how, ratio.rho, ratio.c);
            const Passed wave = passed(ratio, {how});
            CHECK(std::abs(wave.reflected - ratio.reflection()) <= 1e-3);
            CHECK(std::abs(wave.transmitted - (1 + ratio.reflection())) <= 1e-3);
        }
}

TEST_CASE("from water into air little passes, and that little is right", "[media]") {
    for (const std::string& how : {std::string("/output={}"), band_fitted, frozen, fdtd}) {
        CAPTURE(how);
        const Passed wave = passed(water_to_air, {how});
        CHECK(std::abs(wave.reflected - water_to_air.reflection()) <= 1e-3);
        CHECK(std::abs(wave.transmitted / (1 + water_to_air.reflection()) - 1) <= 0.05);
    }
}

TEST_CASE("wide stencils see an interface rightly at moderate contrasts; beyond, what it reflects", "[media]") {
    for (const std::string& how : {fdtd_4, kspace}) {
        for (const Ratio& ratio : {modest, heavy}) {
            CAPTURE(how, ratio.rho, ratio.c);
            const Passed wave = passed(ratio, {how});
            CHECK(std::abs(wave.reflected - ratio.reflection()) <= 1e-3);
            CHECK(std::abs(wave.transmitted - (1 + ratio.reflection())) <= 1e-3);
        }
        for (const Ratio& ratio : {air_to_water, water_to_air}) {
            CAPTURE(how, ratio.rho, ratio.c);
            CHECK(std::abs(passed(ratio, {how, "/integrator/courant=0.4"}).reflected - ratio.reflection()) <= 2e-3);
        }
    }
}

/// Noise in a periodic square, half of which, cut obliquely, is another medium.
std::string noise(const Ratio& ratio, const std::string& set) {
    return R"json({"dimension": 2, "medium": [{"c0": 1, "rho0": 1}, {"region": "x + 0.4*y > 0.55", "c0": )json" + number(ratio.c) + R"json(, "rho0": )json" +
           number(ratio.rho) + R"json(}], "particles": {"type": "lattice", "dx": 0.0625, "lower": [0, 0], "upper": [1, 1]},
        "boundaries": [{"type": "periodic", "face": "all"}], "kernel": {"type": "cubic_spline", "h_over_dx": 1.2}, "equations": )json" + set + R"json(,
        "initial": {"p": "sin(1e4*sin(3e3*x + 7e3*y^2 + 1))", "u": ["0", "0"]},
        "integrator": {"type": "leapfrog", "courant": 0.7}, "until": )json" + number(100 / ratio.c) + "}";
}

TEST_CASE("energy is constant where media meet, obliquely to the lattice too", "[media]") {
    for (const std::string equations : {"\"acoustics\"", "\"band_fitted_acoustics\""})
        for (const Ratio& ratio : {modest, heavy, air_to_water}) {
            CAPTURE(equations, ratio.rho, ratio.c);
            const Summary s = run(scene(noise(ratio, equations)));
            CHECK(std::abs(s.energy_final / s.energy_initial - 1) <= 1e-11);
        }
}

TEST_CASE("the p/rho^2 form blows up at a contrast of ten to one, and the impedance form does not", "[media]") {
    const std::string symmetric = R"({"p": [{"divergence": "u", "form": "difference", "times": "-rho0*c0^2"}],
        "u": [{"gradient": "p", "form": "symmetric", "times": "-1/rho0"}]})";
    CHECK(run(scene(noise(heavy, symmetric), {"/integrator/unstable=allow", "/integrator/courant=0.1"})).diverged);
    CHECK_FALSE(run(scene(noise(heavy, "\"acoustics\""), {"/integrator/courant=0.1"})).diverged);
}
