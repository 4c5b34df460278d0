/// Walls of obstacles: modes of round cavities, and a polygon that is a box.
#include "../support/cavity.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::string adjoint = R"(/equations={"p":[{"divergence":"u","form":"difference","times":"-rho0*c0^2"}],"u":[{"gradient":"p","form":"sum","times":"-1/rho0"}]})";

/// Errors at n, 2n and 4n spacings to the radius, of at least this order from each to the next.
void converges(const CavityMode& mode, int n, double periods, double order, double coarsest, const std::vector<std::string>& set) {
    double before = 0;
    for (const int finer : {1, 2, 4}) {
        const double error = mode_error(mode, finer * n, periods, set);
        INFO(finer * n << " spacings to the radius: " << error << ", before: " << before);
        if (finer == 1) CHECK(error < coarsest);
        if (finer > 1) CHECK(std::log2(before / error) > order);
        before = error;
    }
}

/// A standing wave in the box [0, 1] x [0, 1], cut out of a larger lattice or the whole of one, after `until`.
Profile standing_wave(const std::string& wall, int n, bool polygon) {
    const std::string p = wall == "rigid" ? "cos(2*pi*x)*cos(pi*y)" : "sin(2*pi*x)*sin(pi*y)", dx = Json(1.0 / n).dump();
    const std::string end = polygon ? "0.5" : "0";
    Case c = scene(R"({"dimension": 2, "medium": {"c0": 2, "rho0": 1.5},
        "particles": {"type": "lattice", "dx": )" + dx + R"(, "lower": [-)" + end + ", -" + end + R"(], "upper": [1.5, 1.5]},
        "kernel": {"type": "cubic_spline", "h_over_dx": 1.05}, "equations": "corrected_acoustics",
        "initial": {"p": ")" + p + R"("}, "integrator": {"type": "leapfrog", "courant": 0.5}, "until": 0.3})",
                   polygon ? std::vector<std::string>{R"(/obstacles=[{"type":"polygon","corners":"0 0, 1 0, 1 1, 0 1","keep":"inside","wall":")" + wall + "\"}]"}
                           : std::vector<std::string>{"/particles/upper=[1,1]", R"(/boundaries=[{"face":"all","type":")" + wall + "\"}]"});
    Simulation simulation(c);
    simulation.run();
    return simulation.profile();
}

}    // namespace

TEST_CASE("modes of a round cavity converge at second order, at rigid walls and at soft ones", "[obstacle]") {
    converges(rigid_mode, 10, 1, 1.7, 0.2, {});
    converges(soft_mode, 10, 1, 1.7, 0.2, {});
    converges(rigid_mode, 10, 1, 1.7, 0.2, {adjoint, R"(/kernel={"type":"gaussian","cutoff":4,"h_over_dx":1.3})"});    // of the right speed uncorrected
}

TEST_CASE("modes of a round cavity converge on disordered sets too", "[obstacle]") {
    converges(rigid_mode, 10, 0.5, 1, 0.2, {"/particles/jitter=0.1", "/kernel/h_over_dx=1.3"});
    converges(soft_mode, 10, 0.5, 1, 0.2, {"/particles/type=blue_noise", "/kernel/h_over_dx=1.3"});
}

TEST_CASE("modes of a ball converge", "[obstacle]") {
    for (const CavityMode& mode : {rigid_ball, soft_ball}) {
        const double coarse = mode_error(mode, 6, 0.5), fine = mode_error(mode, 12, 0.5);
        INFO(mode.wall << ": " << coarse << ", " << fine);
        CHECK(fine < 0.1);
        CHECK(coarse / fine > 2.5);
    }
}

TEST_CASE("a polygon along the lattice is the box of these walls, to the order of the set", "[obstacle]") {
    for (const char* wall : {"rigid", "soft"}) {
        double before = 0;
        for (const int n : {16, 32}) {
            const Profile cut = standing_wave(wall, n, true), whole = standing_wave(wall, n, false);
            REQUIRE(cut.p.size() == std::size_t((n + 1) * (n + 1)));
            REQUIRE(whole.p.size() == cut.p.size());
            double squares = 0, norm = 0;
            for (std::size_t i = 0; i < cut.p.size(); ++i) {
                squares += std::pow(cut.p[i] - whole.p[i], 2);
                norm += std::pow(whole.p[i], 2);
            }
            const double difference = std::sqrt(squares / norm);
            INFO(wall << " at " << n << ": " << difference << ", before: " << before);
            if (n == 16) CHECK(difference < 0.1);
            if (n == 32) CHECK(before / difference > 2);
            before = difference;
        }
    }
}
