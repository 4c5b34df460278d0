#include "../support/scene.hpp"

#include <sphonic/plugin/abi/reference.hpp>
#include <sphonic/stability.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

/// A circular pulse, let go in the middle of a plate of n particles per pulse width (0.1 m). At the end, 0.125 s at
/// c0 = 2 m/s, it has run 2.5 widths, and the free edges are still 3.5 widths ahead: there it is exp(-12).
Case plate(int n, const std::string& kernel) {
    return scene(R"({"dimension": 2, "medium": {"c0": 2, "rho0": 1.5},
        "particles": {"type": "lattice", "dx": )" + Json(0.1 / n).dump() + R"(, "lower": [-0.6, -0.6], "upper": [0.6, 0.6]},
        "kernel": )" + kernel + R"json(, "equations": "linear_acoustics", "initial": {"p": "5*exp(-(r/0.1)^2)"},
        "integrator": {"type": "velocity_verlet", "courant": 0.5}, "until": 0.125,
        "reference": {"type": "pulse", "amplitude": 5, "width": 0.1}})json");
}

struct Distance {
    double medium;     ///< from the reference
    double lattice;    ///< from the reference at the speed of the lattice's long waves
};

Distance distance(int n, const std::string& kernel) {
    const Case c = plate(n, kernel);
    Simulation simulation(c);
    simulation.run();
    const Profile now = simulation.profile();
    const double along_x[3] = {1, 0, 0}, t = now.t * long_wave_speed(c, along_x);    // p depends on c0 t alone
    std::vector<double> exact(now.p.size());
    const abi::Points points{.dimension = 2, .n = int(now.p.size()), .x = {now.x[0].data(), now.x[1].data()}};
    c.reference->reference->evaluate(t, points, {.p = exact.data()});
    double squares = 0, norm = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        squares += (now.p[i] - exact[i]) * (now.p[i] - exact[i]);
        norm += exact[i] * exact[i];
    }
    return {simulation.summary().errors->l2, std::sqrt(squares / norm)};
}

}    // namespace

TEST_CASE("a circular pulse converges with order two for a kernel that the lattice sums well", "[convergence]") {
    const std::string kernel = R"({"type": "gaussian", "cutoff": 4, "h_over_dx": 1.3})";
    const double coarse = distance(7, kernel).medium, fine = distance(14, kernel).medium;
    CHECK(std::log2(coarse / fine) == Approx(2).margin(0.1));
    CHECK(fine < 0.05);
}

TEST_CASE("a circular pulse converges to the lattice's sound speed for the cubic kernel at h = dx", "[convergence]") {
    // 1.3 % above c0 in two dimensions; in one it is c0
    const std::string kernel = R"({"type": "cubic_spline", "h_over_dx": 1})";
    const Distance coarse = distance(7, kernel), fine = distance(14, kernel);
    CHECK(std::log2(coarse.lattice / fine.lattice) == Approx(2).margin(0.1));
    CHECK(fine.lattice < 0.02);
    CHECK(std::log2(coarse.medium / fine.medium) < 0.1);
}
