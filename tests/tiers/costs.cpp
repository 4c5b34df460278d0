/// What decides the predicted cost of a step beside particles and neighbours.
#include "cost.hpp"
#include "passes.hpp"

#include "../support/scene.hpp"

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("what a scene asks for beside its neighbours decides its tier and its passes", "[cost]") {
    const auto made = [](const std::vector<std::string>& set) {
        return scene(R"json({"dimension": 2, "medium": {"c0": 340, "rho0": 1.2}, "particles": {"type": "lattice", "dx": 0.01, "lower": [0, 0], "upper": [1.01, 1.01]},
            "kernel": {"type": "cubic_spline", "h_over_dx": 1.2}, "equations": "corrected_acoustics", "boundaries": [{"type": "periodic", "face": "all"}],
            "integrator": {"type": "leapfrog", "courant": 0.5}, "until": 0.01})json", set);
    };
    const std::string jitter = "/particles/jitter=0.2";
    CHECK(cost_tier(made({jitter, R"(/dissipation={"type":"fourth_order"})"}), "frozen", 20) == "frozen_dissipation");
    CHECK(cost_tier(made({jitter}), "frozen", 20) == "frozen");
    CHECK(cost_tier(made({}), "lattice", 44) == "lattice");
    CHECK(cost_tier(made({}), "lattice", 48) == "lattice_wide");
    CHECK(cost_tier(made({"/precision=single"}), "lattice", 48) == "lattice_single_wide");

    const Summary grid{.tier = "fdtd", .particles = 10000, .neighbours_mean = 4};
    const std::string fdtd = R"(/method={"type":"fdtd"})", half = R"(/boundaries=[{"type":"absorbing_layer","face":"x","thickness":0.25},{"type":"periodic","face":"y"}])",
                      body = R"(/obstacles=[{"type":"circle","radius":0.1,"centre":[0.5,0.5],"wall":"rigid"}])";
    const auto cost = [&](const std::string& more) { return passes(reference_costs(), made({fdtd, more}), grid); };
    CHECK(cost("/until=0.02") == 0);
    CHECK(cost(body) > 0);
    CHECK(cost(half) > 2 * cost(body));
    CHECK(transform_factor(made({fdtd}), "kspace") == Approx(7));    // 101 points to an axis, a prime
    CHECK(transform_factor(made({fdtd}), "fdtd") == 1);
}
