/// The absorbing layer: what comes back of a pulse.
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
        CHECK(returned(2, asked) <= -asked + 0.5);
        CHECK(returned(2, asked) >= -asked - 3);
    }
}

TEST_CASE("a layer thinner than the sound returns more: its entrance is steep", "[layer]") {
    CHECK(returned(0.05, 60) > -40);
}

TEST_CASE("a layer absorbs on disordered sets too", "[layer]") {
    CHECK(returned(2, 40, {"/particles/jitter=0.1", "/equations=corrected_acoustics"}) < -35);
}
