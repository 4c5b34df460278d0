/// The absorbing layer: what comes back of a pulse.
#include <sphonic/prediction.hpp>

#include "../support/scene.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

/// A pulse that runs to the right into a layer; the largest pressure that has come back to the middle, over the pulse's, in dB.
double returned(double thickness, double attenuation, const std::vector<std::string>& set = {}) {
    const std::string text = R"json({"dimension": 1, "medium": {"c0": 2, "rho0": 1.5},
        "particles": {"type": "lattice", "dx": 0.01, "lower": [0], "upper": [10]},
        "kernel": {"type": "gaussian", "h_over_dx": 1.3, "cutoff": 4}, "equations": "linear_acoustics",
        "initial": {"p": "exp(-((x-5)/0.2)^2)", "u": ["exp(-((x-5)/0.2)^2)/(rho0*c0)"]},
        "boundaries": [{"type": "rigid", "face": "x_min"}, {"type": "absorbing_layer", "face": "x_max", "thickness": )json" +
                             Json(thickness).dump() + R"(, "attenuation": )" + Json(attenuation).dump() + R"(}],
        "integrator": {"type": "leapfrog", "courant": 0.5}, "until": 4})";
    const Case c = scene(text, set);
    Simulation simulation(c);
    simulation.run();
    const Profile now = simulation.profile();
    double largest = 0;
    for (std::size_t i = 0; i < now.p.size(); ++i)
        if (now.x[0][i] < 10 - thickness) largest = std::max(largest, std::abs(now.p[i]));
    return 20 * std::log10(largest);
}

}    // namespace

TEST_CASE("an absorbing layer returns no more than it is asked to", "[layer]") {
    for (const double asked : {20.0, 40.0, 60.0}) {
        INFO("asked for -" << asked << " dB");
        CHECK(returned(2, asked) <= -asked);
        CHECK(returned(2, asked) >= -asked - 3);
    }
}

TEST_CASE("a layer thinner than the sound returns more: its entrance is steep", "[layer]") {
    CHECK(returned(0.05, 60) > -40);
}

TEST_CASE("a layer absorbs on disordered sets too", "[layer]") {
    CHECK(returned(2, 40, {"/particles/jitter=0.1", "/equations=corrected_acoustics"}) < -35);
}

TEST_CASE("what a layer returns obliquely is as predicted", "[layer]") {
    struct Setting {
        double thickness, angle, height;    // height: one wave along y
    };
    // a packet of waves of length 1
    for (const char* method : {"particles", "fdtd"})
        for (const Setting& at : {Setting{1, 45, 1.4142135623730951}, Setting{2, 60, 1.1547005383792515}}) {
            const double c = std::cos(at.angle * testing::pi / 180), s = std::sin(at.angle * testing::pi / 180), w = 2.5 / c, x0 = 3 + 3.5 * w, end = 2 * x0;
            const std::string packet = "exp(-((x - " + Json(x0).dump() + ")/" + Json(w).dump() + ")^2)*cos(2*pi*(" + Json(c).dump() + "*(x - " + Json(x0).dump() + ") + " +
                                       Json(s).dump() + "*y))";
            const Case scene = repository_case("scenes/layer_2d", {"/boundaries/2/thickness=" + Json(at.thickness).dump(),
                "/particles/dx=" + Json(at.height / std::round(20 * at.height)).dump(), "/particles/upper=[" + Json(end).dump() + "," + Json(at.height).dump() + "]",
                "/initial/p=" + packet, "/initial/u=[\"" + Json(c).dump() + "*" + packet + "\",\"" + Json(s).dump() + "*" + packet + "\"]",
                "/until=" + Json(2 * (end - x0) / c).dump(), "/reference/region=3 < x < " + Json(end - 3).dump(), std::string("/method/type=") + method});
            const double measured = run(scene).errors->max;
            const double predicted = layer_return(*scene.face(0, true), scene.medium, at.thickness, 2 * testing::pi, at.angle * testing::pi / 180);
            CAPTURE(method, at.thickness, at.angle);
            CHECK(measured == Approx(predicted).epsilon(0.1));
        }
}
