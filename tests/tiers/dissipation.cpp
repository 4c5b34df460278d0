/// Dissipation of disordered sets: what it leaves alone, what it keeps, and that the tiers agree on it.
#include "sound.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::string jittered = "/particles/jitter=0.2", wide = "/kernel/h_over_dx=1.3";
const std::string alone = R"(/equations={"p":[{"dissipation":"fourth_order","alpha":0.5}],"u":[{"dissipation":"fourth_order","alpha":0.5}]})";
const std::string top = R"(/dissipation={"type":"fourth_order","alpha":0.3})";

/// Nothing but dissipation in a box of n particles per unit length, ten steps of c0 dt = 0.2 dx long.
Case damped(int dimension, int n, std::vector<std::string> set) {
    set.insert(set.end(), {alone, wide, R"(/integrator={"type":"leapfrog","courant":0.2})", "/until=" + Json(10 * 0.2 / n / 2).dump()});
    return scene(periodic_box(dimension, n), set);
}

struct Change {
    double p = 0, u = 0;
};

/// The largest change that a run makes to p and to u.
Change change(const Case& c) {
    Simulation simulation(c);
    const auto all = [&] {
        const abi::Snapshot now = simulation.solver().snapshot();
        std::vector<double> values(now.p, now.p + now.points.n);
        for (int a = 0; a < c.box.dimension; ++a) values.insert(values.end(), now.u[a], now.u[a] + now.points.n);
        return values;
    };
    const std::vector<double> before = all();
    simulation.run();
    const std::vector<double> after = all();
    Change worst;
    for (std::size_t i = 0; i < after.size(); ++i) {
        double& of = i < after.size() / std::size_t(1 + c.box.dimension) ? worst.p : worst.u;
        of = std::max(of, std::abs(after[i] - before[i]));
    }
    return worst;
}

const char* const lists[] = {"/particles/neighbours=frozen", "/particles/neighbours=moving"};

}    // namespace

TEST_CASE("dissipation leaves linear fields alone on a disordered set that simply ends", "[dissipation]") {
    const std::string p[4] = {"", "3-2*x", "3-2*x+5*y", "3-2*x+5*y-z"};
    const std::string u[4] = {"", R"("1+4*x")", R"("1+4*x-y","2*x+3*y")", R"("1+4*x-y","2*x+3*y-z","7*z")"};
    for (const int d : {1, 2, 3})
        for (const char* list : lists) {
            const int n = d == 3 ? 6 : 15;
            INFO(d << "-D, " << list);
            const Change linear = change(damped(d, n, {"/boundaries=[]", jittered, list, "/initial={\"p\":\"" + p[d] + "\",\"u\":[" + u[d] + "]}"}));
            CHECK(linear.p < 1e-12);
            CHECK(linear.u < 1e-12);
            const Change bent = change(damped(d, n, {"/boundaries=[]", jittered, list, "/initial={\"p\":\"x^2\"}"}));
            CHECK(bent.p > 1e-4);
        }
}

TEST_CASE("dissipation leaves fields alone that are linear with the images beyond walls", "[dissipation][wall]") {
    struct Row {
        const char *type, *p, *u;    // in the box from 0 to 1 between walls of y, x periodic
    };
    for (const Row row : {Row{"rigid", "3", R"("2","4*y")"}, Row{"soft", "4*y", R"("4*y","3")"}})
        for (const char* list : lists) {
            // One wall at y = 0 with parities that the field has; the other end is open.
            const std::string walls = "/boundaries=[" + face("x", "periodic") + "," + face("y_min", row.type) + "]";
            const auto field = [&](const std::string& p, const std::string& u) { return "/initial={\"p\":\"" + p + "\",\"u\":[" + u + "]}"; };
            INFO(row.type << ", " << list);
            const Change linear = change(damped(2, 15, {walls, jittered, list, field(row.p, row.u)}));
            CHECK(linear.p < 1e-12);
            CHECK(linear.u < 1e-12);
            const Change kinked = change(damped(2, 15, {walls, jittered, list, field(*row.type == 'r' ? "y" : "1", R"("y","0")")}));
            CHECK(kinked.p > 1e-3);
        }
}

TEST_CASE("dissipation takes no momentum and no pressure from a periodic set", "[dissipation]") {
    for (const int d : {1, 2, 3})
        for (const char* list : lists) {
            const Case c = damped(d, d == 3 ? 6 : 15, {jittered, list, "/initial/p=sin(40*x)+exp(-x)"});
            Simulation simulation(c);
            const auto total = [&] {
                double sum = 0;
                for (const double p : simulation.profile().p) sum += p;
                return sum;
            };
            const double before = total();
            simulation.run();
            CHECK(total() == Approx(before).epsilon(1e-13));
        }
}

TEST_CASE("dissipation weighs particles by their current volumes, and keeps sums over volume", "[dissipation]") {
    const std::string equations = R"(/equations={"drho":[{"dissipation":"fourth_order","alpha":0.5}],"rho":{"state":"total_density","of":"drho"},
        "p":{"state":"acoustic","of":"drho"},"u":[{"dissipation":"fourth_order","alpha":0.5}]})";
    const Case c = scene(periodic_box(2, 15), {equations, jittered, wide, lists[1], "/initial={\"p\":\"2*sin(2*pi*x)+sin(40*y)\"}",
                                               R"(/integrator={"type":"forward_euler","unstable":"allow","dt":0.001})", "/until=0.001"});
    Simulation simulation(c);
    const Profile before = simulation.profile();
    simulation.run();
    const Profile after = simulation.profile();
    double change = 0, size = 0;
    for (std::size_t i = 0; i < before.p.size(); ++i) {
        const double volume = 1 / (c.medium.rho0 + before.p[i] / (c.medium.c0 * c.medium.c0));    // of particles of equal mass
        change += volume * (after.p[i] - before.p[i]);
        size += volume * std::abs(after.p[i] - before.p[i]);
    }
    CHECK(size > 0.1);
    CHECK(std::abs(change) < 1e-12 * size);
}

TEST_CASE("kept weights and a moving list agree on dissipation", "[tiers][dissipation]") {
    const auto agree = [](int d, const std::string& boundaries, const std::string& equations) {
        std::vector<std::string> set{"/boundaries=[" + boundaries + "]", equations, wide, jittered, top,
                                     R"(/integrator={"type":"velocity_verlet","courant":0.3})", "/until=0.1"};
        const int n = d == 3 ? 7 : 15;
        const Profile kept = final_state(d, n, set);
        set.push_back(lists[1]);
        INFO(d << "-D, " << boundaries << ", " << equations);
        CHECK(largest_difference(kept, final_state(d, n, set)) < 1e-12);
    };
    for (const auto& equations : {forms("corrected", "corrected"), forms("difference", "sum")})
        for (const int d : {1, 2})
            for (const char* boundaries : {"free", "periodic", "rigid", "soft"}) agree(d, face("all", boundaries), equations);
    agree(3, face("x", "rigid") + "," + face("y", "soft") + "," + face("z", "periodic"), forms("corrected", "corrected"));
    agree(2, face("x", "rigid", "half_way") + "," + face("y", "soft", "half_way"), forms("corrected", "corrected"));
}

TEST_CASE("a lattice between walls is damped as a periodic one of twice the length", "[dissipation][wall]") {
    for (const char* type : {"rigid", "soft"})
        for (const char* list : lists) {
            const bool rigid = *type == 'r';
            const std::string wave = rigid ? "cos(3*pi*x)+0.5*cos(7*pi*x)" : "sin(3*pi*x)+0.5*sin(7*pi*x)";
            const auto pressures = [&](bool folded) {
                const Case c = scene(periodic_box(1, 16, folded ? 1 : 2), {"/boundaries=[" + face("x", folded ? type : "periodic") + "]", list, wide, top,
                                                                          forms("corrected", "corrected"), "/initial/p=" + wave, "/until=0.3"});
                Simulation simulation(c);
                simulation.run();
                return simulation.profile().p;
            };
            const auto half = pressures(true), whole = pressures(false);
            for (std::size_t i = 0; i < half.size(); ++i) CHECK(half[i] == Approx(whole[i]).margin(1e-13));
        }
}

TEST_CASE("dissipation written as terms is that of the top level, also where p comes from a density", "[dissipation]") {
    const auto end = [](const std::vector<std::string>& set) {
        std::vector<std::string> all{wide, jittered, "/integrator/courant=0.3"};
        all.insert(all.end(), set.begin(), set.end());
        return final_state(2, 15, all);
    };
    const std::string p = R"({"divergence":"u","form":"corrected","times":"-rho0*c0^2"})", u = R"({"gradient":"p","form":"corrected","times":"-1/rho0"})";
    const std::string term = R"(,{"dissipation":"fourth_order","alpha":0.3})";
    const Profile at_top = end({forms("corrected", "corrected"), top});
    const Profile written = end({"/equations={\"p\":[" + p + term + "],\"u\":[" + u + term + "]}"});
    CHECK(largest_difference(at_top, written) == 0);
    const Profile of_density = end({R"(/equations={"drho":[{"divergence":"u","form":"corrected","times":"-rho0"}],"p":{"state":"acoustic","of":"drho"},"u":[)" + u + "]}", top});
    CHECK(largest_difference(at_top, of_density) < 1e-12);
    CHECK(largest_difference(at_top, end({forms("corrected", "corrected")})) > 1e-3);
}

TEST_CASE("the usual strength follows the disorder, and a resolved case carries it", "[dissipation]") {
    const auto strength = [](const std::vector<std::string>& set) {
        std::vector<std::string> all{wide, R"(/dissipation={"type":"fourth_order"})"};
        all.insert(all.end(), set.begin(), set.end());
        const Case c = scene(periodic_box(2, 40), all);
        const double alpha = (*c.resolved)["dissipation"]["alpha"];
        for (const Variable& v : c.equations.variables) CHECK(v.terms.back().coefficient[0] == alpha);
        const Case again = load_case(*c.resolved, c.file, registry());
        CHECK(*again.resolved == *c.resolved);
        return alpha;
    };
    CHECK(strength({}) == 0);
    const double little = strength({"/particles/jitter=0.1"});
    CHECK(little == Approx(3.5 * 0.28 * 0.1).epsilon(0.1));
    CHECK(strength({"/particles/jitter=0.2"}) == Approx(2 * little).epsilon(0.1));
    CHECK(strength({"/particles/jitter=0.1", "/boundaries=[" + face("all", "rigid") + "]"}) == Approx(little).epsilon(0.1));    // ends do not count
    CHECK(strength({"/particles/jitter=0.1", "/kernel/h_over_dx=2"}) < 0.6 * little);
}
