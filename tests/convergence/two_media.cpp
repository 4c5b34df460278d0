#include "../support/media_pulse.hpp"

/// Pulses from one medium into another, against R = (Z2 - Z1)/(Z2 + Z1) and T = 2 Z2/(Z2 + Z1).
using namespace sphonic;
using namespace sphonic::testing;
using namespace sphonic::testing::media;

namespace {

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
