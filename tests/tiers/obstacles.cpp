/// Sets that obstacles have cut: the same sound by kept weights and by those computed anew, for any number of threads, and as far
/// as symmetry or nothing at all goes.
#include "../support/cavity.hpp"
#include "sound.hpp"

#include <sphonic/error.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::string click = "exp(-((x-0.2)^2+(y-0.1)^2)/0.09)";

Profile after(const std::string& text, const std::vector<std::string>& set) {
    const Case c = scene(text, set);
    Simulation simulation(c);
    simulation.run();
    return simulation.profile();
}

}    // namespace

TEST_CASE("walls of obstacles agree between kept weights and those computed anew", "[tiers][obstacle]") {
    for (const int d : {2, 3})
        for (const char* wall : {"rigid", "soft"})
            for (const auto& equations : {forms("corrected", "corrected_adjoint"), forms("difference", "sum")}) {
                const std::string text = cavity(d, wall, d == 3 ? 4 : 10, click, 0.1);
                std::vector<std::string> set{equations, "/kernel/h_over_dx=1.3", "/particles/jitter=0.1", "/integrator/courant=0.3"};
                const Profile kept = after(text, set);
                set.push_back("/particles/neighbours=moving");
                INFO(d << "-D, " << wall << ", " << equations);
                CHECK(largest_difference(kept, after(text, set)) < 1e-12);
            }
}

TEST_CASE("on a lattice's sites, whose rows share their weights, sound at obstacles is the same", "[tiers][obstacle]") {
    for (const int d : {2, 3})
        for (const auto& equations : {forms("corrected", "corrected_adjoint"), forms("corrected", "corrected"), forms("difference", "sum")}) {
            const std::string text = cavity(d, "rigid", d == 3 ? 6 : 16, click, 0.2);
            std::vector<std::string> set{equations, "/kernel/h_over_dx=1", "/integrator/courant=0.3"};
            const Profile kept = after(text, set);
            set.push_back("/particles/neighbours=moving");
            INFO(d << "-D, " << equations);
            CHECK(largest_difference(kept, after(text, set)) < 1e-10);
        }
}

TEST_CASE("sound at obstacles does not depend on the number of threads", "[tiers][obstacle]") {
    const std::string text = cavity(2, "soft", 50, click, 0.05);
    Case one = scene(text), three = scene(text);
    one.threads = 1;
    three.threads = 3;
    Simulation first(one), second(three);
    first.run();
    second.run();
    CHECK(first.profile().p == second.profile().p);
}

TEST_CASE("sound uniform in space stays so at rigid obstacles, and expands nowhere", "[obstacle]") {
    for (const int d : {2, 3})
        for (const char* jitter : {"0", "0.2"}) {
            const Profile now = after(cavity(d, "rigid", d == 3 ? 5 : 8, "3", 0.2), {std::string("/particles/jitter=") + jitter, "/kernel/h_over_dx=1.3"});
            for (const double p : now.p) CHECK(p == Approx(3).epsilon(1e-12));
        }
}

TEST_CASE("half a body on a rigid floor sounds as the whole one does with its mirror image", "[obstacle]") {
    const auto body = [](double from, const std::string& boundaries) {
        return after(cavity(2, "rigid", 10, "exp(-((x-1.6)^2+y^2)/0.09)", 1.5),
                     {"/particles/lower=[-2.5," + Json(from).dump() + "]", "/particles/upper=[2.5,2.5]", boundaries,
                      R"(/obstacles=[{"type":"circle","radius":1.03,"wall":"rigid"}])"});
    };
    const Profile whole = body(-2.5, R"(/boundaries=[{"type":"rigid","face":"all"}])"), half = body(0, R"(/boundaries=[{"type":"rigid","face":"all"}])");
    double worst = 0, loudest = 0;
    for (std::size_t i = 0; i < half.p.size(); ++i)
        for (std::size_t j = 0; j < whole.p.size(); ++j) {
            if (std::hypot(half.x[0][i] - whole.x[0][j], half.x[1][i] - whole.x[1][j]) > 1e-6) continue;
            worst = std::max(worst, std::abs(half.p[i] - whole.p[j]));
            loudest = std::max(loudest, std::abs(whole.p[j]));
        }
    INFO("differs by " << worst << " of " << loudest);
    CHECK(loudest > 0.1);
    CHECK(worst < 0.01 * loudest);    // smoothing at the wall ends where the floor begins
}

TEST_CASE("a body across a periodic face is one with its other part", "[obstacle]") {
    const auto shifted = [](double centre) {
        return after(cavity(2, "rigid", 10, "0", 0.7), {"/particles/lower=[0,-2]", "/particles/upper=[4,2]", R"(/boundaries=[{"type":"periodic","face":"all"}])",
                                                        R"(/obstacles=[{"type":"circle","radius":1,"centre":[)" + Json(centre).dump() + ",0.04]}]",
                                                        "/initial/p=cos(pi*(x-" + Json(centre).dump() + ")/2)*cos(pi*y/2)"});
    };
    const Profile middle = shifted(2.03), split = shifted(0.03);
    REQUIRE(middle.p.size() == split.p.size());
    double worst = 0;
    for (std::size_t i = 0; i < split.p.size(); ++i)
        for (std::size_t j = 0; j < middle.p.size(); ++j) {
            const double x = split.x[0][i] + 2 - middle.x[0][j], y = split.x[1][i] - middle.x[1][j];
            if (std::hypot(x - 4 * std::round(x / 4), y) < 1e-6) worst = std::max(worst, std::abs(split.p[i] - middle.p[j]));
        }
    CHECK(worst < 1e-11);
}

TEST_CASE("a free obstacle only cuts particles out", "[obstacle]") {
    const std::string text = cavity(2, "free", 8, click, 0.1);
    const Case c = scene(text);
    CHECK(c.particles < c.arrangement->size(c.box));
    CHECK_FALSE(c.regular());
    Simulation simulation(c);
    simulation.run();
    CHECK(simulation.summary().tier == "frozen");
    const Profile now = simulation.profile();
    CHECK(long(now.p.size()) == c.particles);
    for (std::size_t i = 0; i < now.p.size(); ++i) CHECK(std::hypot(now.x[0][i], now.x[1][i]) <= 1 + 1e-9);
}
