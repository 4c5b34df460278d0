/// Walls, layers and what a grid refuses.
#include "grids.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

struct Wall {
    const char *type, *place;

    bool rigid() const { return *type == 'r'; }
    bool half_way() const { return *place == 'h'; }
};
constexpr Wall walls[] = {{"rigid", "on_particles"}, {"rigid", "half_way"}, {"soft", "on_particles"}, {"soft", "half_way"}};

std::vector<double> pressures(const std::string& text, const std::vector<std::string>& set) {
    const Case c = scene(text, set);
    Simulation simulation(c);
    simulation.run();
    return simulation.profile().p;
}

/// `box` of ten spacings between walls at 0 and 1, or the periodic one of twice the length, in which the same sound is even or odd.
std::vector<double> between(int d, const Wall& wall, const std::string& method, bool folded, const std::string& medium) {
    const double dx = 0.1, shift = wall.half_way() ? dx / 2 : 0;
    std::string lower, upper, p, u;
    for (int a = 0; a < d; ++a) {
        const std::string x(1, "xyz"[a]), shape = wall.rigid() ? "(cos(pi*" + x + ")+0.3*cos(3*pi*" + x + "))" : "(sin(pi*" + x + ")-0.4*sin(4*pi*" + x + "))";
        lower += (a ? "," : "") + number((folded ? 0 : -1) + shift);
        upper += (a ? "," : "") + number(folded ? 1 - shift : 1 + shift);
        p += (a ? "*" : "") + shape;
        u += (a ? ",\"" : "\"") + std::string("0.2*") + (wall.rigid() ? "sin(2*pi*" : "cos(2*pi*") + x + ")";
        for (int b = 0; b < d; ++b)
            if (b != a) u += std::string("*") + (wall.rigid() ? "cos(pi*" : "sin(pi*") + "xyz"[b] + ")";
        u += "\"";
    }
    const std::string boundary = folded ? face("all", wall.type, wall.place) : face("all", "periodic");
    return pressures(periodic_box(d, 10), {method, medium, "/particles/lower=[" + lower + "]", "/particles/upper=[" + upper + "]", "/boundaries=[" + boundary + "]",
                                           "/initial={\"p\":\"" + p + "\",\"u\":[" + u + "]}", "/integrator/courant=0.25", "/until=1.7"});
}

const std::string one = R"json(/medium={"c0":2,"rho0":1.5})json", two = R"json(/medium=[{"c0":2,"rho0":1.5},{"region":"0.43 < abs(x) < 0.77","c0":3,"rho0":0.5}])json";

}    // namespace

TEST_CASE("a box between walls is one half of a periodic box", "[methods][wall]") {
    for (const std::string& method : {fdtd, fdtd_4})
        for (const int d : {1, 2, 3})
            for (const Wall& wall : walls)
                for (const std::string& medium : {one, two}) {
                    CAPTURE(method, d, wall.type, wall.place, medium);
                    const auto half = between(d, wall, method, true, medium), whole = between(d, wall, method, false, medium);
                    const long n = wall.half_way() ? 10 : 11, m = 20;
                    double worst = 0;
                    for (std::size_t i = 0; i < half.size(); ++i) {
                        const long site[3] = {long(i) % n, long(i) / n % n, long(i) / n / n};
                        long at = 0;
                        for (int a = d - 1; a >= 0; --a) at = at * m + (site[a] + 10) % m;
                        worst = std::max(worst, std::abs(half[i] - whole[std::size_t(at)]));
                    }
                    CHECK(worst < 1e-12);
                }
}

TEST_CASE("energy is constant between walls of all kinds", "[methods][wall][energy]") {
    const std::string mixed = "/boundaries=[" + face("x_min", "rigid", "half_way") + "," + face("x_max", "soft", "on_particles") + "," +
                              face("y_min", "soft", "half_way") + "," + face("y_max", "free") + "]";
    for (const std::string& method : {fdtd, fdtd_4})
        for (const std::string& medium : {one, two}) {
            const auto steady = [&](int d, const std::string& boundaries) {
                CAPTURE(method, medium, boundaries, d);
                const Summary s = run(scene(periodic_box(d, d == 3 ? 9 : 21), {method, medium, boundaries, "/initial/p=" + noise(d),
                                                                               "/integrator={\"type\":\"leapfrog\"}", "/until=5"}));
                CHECK(std::abs(s.energy_final / s.energy_initial - 1) < 1e-12);
            };
            for (const int d : {1, 2, 3})
                for (const Wall& wall : walls) steady(d, "/boundaries=[" + face("all", wall.type, wall.place) + "]");
            steady(2, mixed);
        }
}

TEST_CASE("a soft wall by differences is a soft wall", "[methods][wall]") {
    const auto against = [](const std::string& wall) {
        return pressures(periodic_box(1, 40), {fdtd, "/boundaries=[" + face("x_min", "rigid") + "," + face("x_max", wall) + "]",
                                               "/initial/p=exp(-((x-0.5)/0.1)^2)", "/until=1.3"});
    };
    CHECK(largest_difference(against("soft"), against("soft_fdtd")) < 1e-12);
}

namespace {

/// What is left, over the first amplitude, when a pulse has run against a face and anything that returns has come half-way back.
double returned(const std::string& method, const std::string& boundaries, double dx = 0.01) {
    const Case c = scene(R"json({"dimension": 1, "medium": {"c0": 2, "rho0": 1.5}, "particles": {"type": "lattice", "dx": )json" + number(dx) +
                             R"json(, "lower": [0], "upper": [10]}, "initial": {"p": "exp(-((x-5)/0.2)^2)", "u": ["exp(-((x-5)/0.2)^2)/(rho0*c0)"]},
        "integrator": {"type": "leapfrog", "courant": 0.5}, "until": 4})json", {method, boundaries});
    Simulation simulation(c);
    simulation.run();
    const Profile now = simulation.profile();
    double largest = 0;
    for (std::size_t i = 0; i < now.p.size(); ++i)
        if (now.x[0][i] > 2 && now.x[0][i] < 8) largest = std::max(largest, std::abs(now.p[i]));
    return largest;
}

std::string layer(const std::string& where, double attenuation) {
    return R"({"face":")" + where + R"(","type":"absorbing_layer","thickness":2,"attenuation":)" + number(attenuation) + "}";
}

}    // namespace

TEST_CASE("an absorbing layer returns no more than it is asked to, on grids too", "[methods][layer]") {
    for (const double asked : {20.0, 40.0, 60.0}) {
        const auto decibels = [&](const std::string& method, const std::string& boundaries) { return 20 * std::log10(returned(method, boundaries)); };
        for (const std::string& method : {fdtd, fdtd_4}) {
            const double back = decibels(method, "/boundaries=[" + face("x_min", "rigid") + "," + layer("x_max", asked) + "]");
            CAPTURE(method, asked);
            CHECK(back <= -asked);
            CHECK(back >= -asked - 3);
        }
        const double through = decibels(kspace, "/boundaries=[" + layer("x", asked) + "]");    // into the layer of the other end
        CAPTURE(asked);
        CHECK(through <= -asked);
        CHECK(through >= -asked - 3);
    }
}

TEST_CASE("Mur's condition lets a pulse out, the better the finer the grid", "[methods][wall]") {
    for (const char* side : {"x_max", "x_min"}) {
        const std::string other = *std::string(side).rbegin() == 'x' ? "x_min" : "x_max";
        const auto error = [&](double dx) {
            const std::string text = R"json({"dimension": 1, "medium": {"c0": 2, "rho0": 1.5}, "particles": {"type": "lattice", "dx": )json" + number(dx) +
                                     R"json(, "lower": [-1], "upper": [1]}, "integrator": {"type": "leapfrog", "courant": 0.5}, "until": 1})json";
            const std::string sign = other == "x_min" ? "" : "-";
            const auto p = pressures(text, {fdtd, "/boundaries=[" + face(side, "absorbing_mur") + "," + face(other, "rigid") + "]", "/initial/p=exp(-(x/0.15)^2)",
                                            "/initial/u=[\"" + sign + "exp(-(x/0.15)^2)/(rho0*c0)\"]"});
            double largest = 0;
            for (const double x : p) largest = std::max(largest, std::abs(x));
            return largest;
        };
        const double coarse = error(0.02), fine = error(0.01);
        CAPTURE(side, coarse, fine);
        CHECK(coarse < 5e-3);
        CHECK(coarse / fine > 3.5);
    }
}

TEST_CASE("what a grid cannot do is refused", "[methods][errors]") {
    const auto refused = [](const std::vector<std::string>& set, const std::string& problem, const std::string& remedy) {
        const Case c = scene(periodic_box(2, 10), set);
        CHECK_THROWS_WITH(Simulation(c), Catch::Contains("/method") && Catch::Contains(problem) && Catch::Contains(remedy));
    };
    refused({R"(/method={"type":"fdtd","order":3})"}, "no order 3", "choose 2 or 4");
    refused({fdtd_4, "/particles/dx=0.5"}, "four points along each axis", "choose order 2");
    for (const char* type : {"absorbing_mur", "soft_fdtd"})
        refused({fdtd_4, "/boundaries=[" + face("x", "periodic") + "," + face("y_max", type) + "]"}, "the boundary of y_max is made for one layer", "choose order 2");
    for (const char* type : {"rigid", "soft", "absorbing_mur", "free"})
        refused({kspace, "/boundaries=[" + face("x", "periodic") + "," + face("y", type) + "]"}, "its face y_min does neither", "make the axis periodic");
    refused({kspace, "/boundaries=[" + face("x", "periodic") + "," + layer("y_max", 40) + "]"}, "its face y_min does neither", "absorbing_layer");
}

TEST_CASE("a step beyond a grid's limit grows, and the run stops", "[methods][errors]") {
    for (const std::string& method : {fdtd, fdtd_4})
        for (const int d : {1, 2, 3}) {
            const auto diverges = [&](double courant) {
                return run(scene(periodic_box(d, 12), {method, "/initial/p=" + noise(d),
                                                       R"(/integrator={"type":"leapfrog","unstable":"allow","courant":)" + number(courant) + "}",
                                                       "/until=" + number(2000 * courant / 24)})).diverged;
            };
            const double limit = (method == fdtd ? 1 : 6. / 7) / std::sqrt(d);
            CAPTURE(method, d);
            CHECK_FALSE(diverges(0.998 * limit));
            CHECK(diverges(1.01 * limit));
        }
}
