/// What dissipation does to corrected forms on disordered sets: the assembled operator, long runs, the stable step.
#include "../support/scene.hpp"

#include <algorithm>

#include <sphonic/prediction.hpp>
#include <sphonic/stability.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::string corrected = "/equations=corrected_acoustics", wide = "/kernel/h_over_dx=1.3", usual = R"(/dissipation={"type":"fourth_order"})";

std::string strength(double alpha) { return R"(/dissipation={"type":"fourth_order","alpha":)" + Json(alpha).dump() + "}"; }
std::string closed(const std::string& type) { return R"(/boundaries=[{"face":"all","type":")" + type + R"("}])"; }
std::string jitter(double fraction, int seed = 1) { return R"(/particles/jitter=)" + Json(fraction).dump() + "&/particles/seed=" + std::to_string(seed); }

/// A box of n particles per unit length in the plane; settings may be joined by &.
Case box(int n, const std::vector<std::string>& set) {
    std::vector<std::string> all{corrected, wide};
    for (const std::string& some : set) {
        const auto cut = some.find('&');
        all.push_back(some.substr(0, cut));
        if (cut != some.npos) all.push_back(some.substr(cut + 1));
    }
    return scene(periodic_box(2, n), all);
}

/// Largest real part of an operator's eigenvalues, over c0/dx.
double growth(const Case& c, const Symbol& A) {
    double largest = -INFINITY;
    for (const auto& value : eigenvalues(A)) largest = std::max(largest, value.real());
    return largest * c.box.dx / c.medium.c0;
}

/// What the dissipation of a set does to its energy 1/2 sum w V [p^2/K + rho0 u^2], w = 1/2 per wall through a particle: the
/// symmetric part of its operator in values whose squares make it up.
Symbol energy_rate(const Case& c) {
    Symbol D = assembled(c, 1);
    const Symbol rest = assembled(c, 0);
    const Profile set = Simulation(c).profile();
    const std::size_t n = std::size_t(D.n), particles = set.p.size();
    std::vector<double> scale;
    for (std::size_t k = 0; k < n; ++k) {
        double weight = k < particles ? 1 / std::pow(c.medium.rho0 * c.medium.c0, 2) : 1;    // p comes first
        for (int a = 0; a < c.box.dimension; ++a) {
            const double x = set.x[a][k % particles];
            if (!c.box.periodic[a] && (x == c.box.lower[a] || x == c.box.upper[a])) weight /= 2;
        }
        scale.push_back(std::sqrt(weight));
    }
    for (std::size_t k = 0; k < n * n; ++k) D.a[k] = (D.a[k] - rest.a[k]) * scale[k / n] / scale[k % n];
    Symbol symmetric = D;
    for (std::size_t row = 0; row < n; ++row)
        for (std::size_t column = 0; column < n; ++column) symmetric.a[row * n + column] = 0.5 * (D.a[row * n + column] + D.a[column * n + row]);
    return symmetric;
}

}    // namespace

TEST_CASE("corrected forms on a disordered set grow, and the usual dissipation leaves no eigenvalue that does", "[dissipation]") {
    for (const char* boundary : {"periodic", "rigid"})
        for (const double fraction : {0.1, 0.2})
            for (const int seed : {1, 2}) {
                const Case c = box(11, {closed(boundary), jitter(fraction, seed), usual});
                INFO(boundary << ", jitter " << fraction << ", seed " << seed);
                CHECK(growth(c, assembled(c, 0)) > 0.01);
                CHECK(growth(c, assembled(c)) < 1e-13);
            }
}

TEST_CASE("dissipation takes energy out of every field of a closed set, and puts none in", "[dissipation]") {
    for (const char* boundary : {"periodic", "rigid", "soft"})
        for (const double fraction : {0.0, 0.3}) {
            const Case c = box(9, {closed(boundary), jitter(fraction), strength(1), "/particles/neighbours=frozen"});
            INFO(boundary << ", jitter " << fraction);
            CHECK(growth(c, energy_rate(c)) < 1e-13);
        }
}

TEST_CASE("a box with rigid walls lasts for fifty passages with dissipation, and blows up without", "[dissipation]") {
    const std::vector<std::string> mode{closed("rigid"), jitter(0.2), "/initial/p=cos(2*pi*x)*cos(pi*y)", "/integrator/courant=0.8", "/integrator/unstable=allow", "/until=25"};
    const auto end = [&](const char* integrator, bool damped) {
        std::vector<std::string> set = mode;
        set.push_back(std::string("/integrator/type=") + integrator);
        if (damped) set.push_back(usual);
        return run(box(24, set));
    };
    for (const char* integrator : {"velocity_verlet", "leapfrog", "rk4"}) {
        INFO(integrator);
        const Summary damped = end(integrator, true);
        CHECK(damped.tier == "frozen");
        CHECK(damped.t == 25);
        CHECK_FALSE(damped.diverged);
        CHECK(damped.energy_final > 0);
        CHECK(damped.energy_final < damped.energy_initial);
        const Summary bare = end(integrator, false);
        CHECK(bare.diverged);
        CHECK(bare.t < 25);
    }
}

TEST_CASE("a plane wave on a lattice decays as the symbol says", "[dissipation][symbol]") {
    for (const auto& [m, n] : {std::pair{2, 0}, {3, 2}, {5, 5}, {8, 1}})
        for (const double alpha : {0.1, 0.5}) {
            const std::string phase = "2*pi*(" + std::to_string(m) + "*x+" + std::to_string(n) + "*y)";
            const double k[3] = {2 * testing::pi * m, 2 * testing::pi * n, 0}, length = std::hypot(k[0], k[1]), along[3] = {k[0] / length, k[1] / length, 0};
            const Case c = box(24, {strength(alpha), "/initial/p=cos(" + phase + ")", "/until=0.4", R"(/integrator={"type":"rk4","courant":0.3})"});
            Simulation simulation(c);
            CHECK(simulation.summary().tier == "frozen");
            const auto amplitude = [&] {    // of the two waves that make up the standing one, from p and u
                const abi::Snapshot now = simulation.solver().snapshot();
                double p = 0, u = 0;
                for (int i = 0; i < now.points.n; ++i) {
                    const double angle = k[0] * now.points.x[0][i] + k[1] * now.points.x[1][i];
                    p += now.p[i] * std::cos(angle);
                    u += (along[0] * now.u[0][i] + along[1] * now.u[1][i]) * std::sin(angle) * c.medium.rho0 * c.medium.c0;
                }
                return std::hypot(p, u);
            };
            const double before = amplitude();
            simulation.run();
            const double decay = std::log(before / amplitude()) / c.until, predicted = travelling_mode(c, length, along, simulation.summary().dt, {}).decay;
            INFO("k dx = " << length * c.box.dx << ", alpha = " << alpha);
            CHECK(decay == Approx(predicted).epsilon(1e-3));
        }
}

TEST_CASE("the symbol of dissipation is real and negative, of fourth order in k", "[dissipation][symbol]") {
    for (const double h : {1.0, 1.3, 2.0}) {
        const Case c = box(20, {strength(1), "/kernel/h_over_dx=" + Json(h).dump()});
        const auto rate = [&](double kx, double ky) {
            const double k[3] = {kx / c.box.dx, ky / c.box.dx, 0};
            const Symbol all = symbol(c, k), rest = symbol(c, k, undamped);
            for (int row = 0; row < all.n; ++row)
                for (int column = 0; column < all.n; ++column)
                    if (row != column) CHECK(all.a[std::size_t(row * all.n + column)] == rest.a[std::size_t(row * all.n + column)]);
            return (all.a[0] - rest.a[0]) * c.box.dx / c.medium.c0;
        };
        INFO("h/dx = " << h);
        for (int i = 0; i <= 16; ++i)
            for (int j = 0; j <= 16; ++j)
                if (i + j > 0) CHECK(rate(i * testing::pi / 16, j * testing::pi / 16) < 0);
        CHECK(std::log2(rate(0.1, 0.05) / rate(0.05, 0.025)) == Approx(4).margin(0.02));
    }
}

TEST_CASE("the limit with dissipation is exact on a lattice", "[dissipation][limit]") {
    for (const char* integrator : {"leapfrog", "rk4"}) {
        const auto at = [&](double fraction) {
            const std::vector<std::string> set{strength(0.4), "/initial/p=cos(1000*x)*sin(777*y)"};
            const double limit = step_limit(box(24, {strength(0.4), std::string("/integrator/type=") + integrator})).dt;
            std::vector<std::string> all = set;
            all.push_back(std::string(R"(/integrator={"type":")") + integrator + R"(","unstable":"allow","dt":)" + Json(fraction * limit).dump() + "}");
            all.push_back("/until=40");
            return run(box(24, all));
        };
        INFO(integrator);
        const Summary below = at(0.99);
        CHECK(below.energy_final < below.energy_initial);
        CHECK(at(1.01).diverged);
    }
}

TEST_CASE("the limit with dissipation holds on disordered sets, and leapfrog bears little more", "[dissipation][limit]") {
    for (const char* boundary : {"periodic", "rigid", "soft"})
        for (const char* integrator : {"leapfrog", "rk4", "ab2"})
            for (const double alpha : {0.2, 0.3, 0.5}) {
                const auto end = [&](const std::string& step) {
                    return run(box(16, {closed(boundary), jitter(0.2), strength(alpha), "/initial/p=cos(1000*x)*sin(777*y)", "/until=20",
                                        std::string(R"(/integrator={"type":")") + integrator + "\"," + step + "}"}));
                };
                INFO(boundary << ", " << integrator << ", alpha " << alpha);
                const Summary below = end(R"("safety":0.99)");
                CHECK_FALSE(below.diverged);
                CHECK(below.energy_final < below.energy_initial);
                if (std::string(integrator) == "leapfrog") CHECK(end(R"("unstable":"allow","dt":)" + Json(1.06 * below.dt_limit).dump()).diverged);
            }
}

TEST_CASE("the limit holds where there is nothing but dissipation", "[dissipation][limit]") {
    const std::string alone = R"(/equations={"p":[{"dissipation":"fourth_order","alpha":0.5}],"u":[{"dissipation":"fourth_order","alpha":0.5}]})";
    for (const char* integrator : {"leapfrog", "rk4", "ab2"}) {
        const auto end = [&](const std::string& step) {
            return run(box(12, {closed("rigid"), jitter(0.2), "/initial/p=cos(1000*x)*sin(777*y)", "/until=40", alone,
                                std::string(R"(/integrator={"type":")") + integrator + "\"," + step + "}"}));
        };
        INFO(integrator);
        const Summary below = end(R"("safety":0.99)");
        CHECK_FALSE(below.diverged);
        CHECK(below.energy_final < below.energy_initial);
        if (std::string(integrator) != "ab2") CHECK(end(R"("unstable":"allow","dt":)" + Json(1.06 * below.dt_limit).dump()).diverged);
    }
}
