#include <cmath>

#include <sphonic/prediction.hpp>

#include "sound.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::string rigid = R"(/boundaries=[{"type":"rigid","face":"all"}])";

/// RMS difference of the pressures of a case in both precisions, over their RMS, and the steps between.
struct Rounding {
    double relative;
    long steps;
};
Rounding rounding(int dimension, int n, std::vector<std::string> set) {
    const Case usual = sounding(dimension, n, set);
    set.push_back("/precision=single");
    const Case single = sounding(dimension, n, set);
    Simulation one(usual), other(single);
    one.run();
    other.run();
    REQUIRE(other.summary().tier == "lattice, single precision");
    const Profile a = one.profile(), b = other.profile();
    double difference = 0, power = 0;
    for (std::size_t i = 0; i < a.p.size(); ++i) {
        difference += std::pow(a.p[i] - b.p[i], 2);
        power += a.p[i] * a.p[i];
    }
    return {std::sqrt(difference / power), one.summary().steps};
}

std::string media(const char* region) { return std::string(R"(/medium=[{"c0":1,"rho0":1},{"c0":2,"rho0":3,"region":")") + region + R"("}])"; }

}    // namespace

TEST_CASE("single precision gives what double precision gives, to its rounding", "[single]") {
    const std::vector<std::vector<std::string>> all{
        {rigid},
        {R"(/boundaries=[{"type":"soft","face":"all","wall":"half_way"}])"},
        {"/boundaries=[]"},
        {rigid, "/equations=corrected_acoustics", R"(/integrator={"type":"rk4"})"},
        {rigid, "/equations=band_fitted_acoustics", R"(/integrator={"type":"leapfrog"})"},
        {rigid, "/equations=acoustics", media("x > 0.4")},
        {R"(/boundaries=[{"type":"absorbing_layer","face":"x","thickness":0.2},{"type":"rigid","face":"y"},{"type":"rigid","face":"z"}])"},
        {rigid, R"json(/sources=[{"type":"point","position":[0.5],"signal":"gaussian","duration":0.1,"flow":1}])json"},
        {R"(/boundaries=[{"type":"absorbing_mur","face":"all"}])"}};
    for (const int d : {1, 2, 3})
        for (std::size_t k = 0; k < all.size(); ++k) {
            std::vector<std::string> set = all[k];
            if (k >= 7 && d > 1) continue;
            if (k == 6 && d < 3) set = {std::string(R"(/boundaries=[{"type":"absorbing_layer","face":"x","thickness":0.2})") + (d > 1 ? R"(,{"type":"rigid","face":"y"}])" : "]")};
            set.push_back("/kernel/h_over_dx=1.3");
            INFO(d << "-D, " << set[0] << " " << (set.size() > 1 ? set[1] : ""));
            const Rounding found = rounding(d, d == 3 ? 11 : 31, set);
            CHECK(found.relative > 0);
            CHECK(found.relative < 10 * rounding_floor(found.steps));
        }
}

TEST_CASE("the error of single precision is of the order that is told before the run", "[single]") {
    for (const int d : {1, 2})
        for (const char* courant : {"0.1", "0.5"})
            for (const char* until : {"1", "10", "100"}) {
                const Rounding found = rounding(d, 31, {rigid, "/kernel/h_over_dx=1.3", std::string("/until=") + until, std::string(R"(/integrator={"type":"leapfrog","courant":)") + courant + "}"});
                INFO(d << "-D, C = " << courant << ", " << found.steps << " steps");
                CHECK(found.relative > 0.2 * rounding_floor(found.steps));
                CHECK(found.relative < 5 * rounding_floor(found.steps));
            }
}

TEST_CASE("in single precision neither energy is lost nor bits depend on threads", "[single]") {
    std::vector<std::string> set{rigid, "/kernel/h_over_dx=1.3", "/until=50", "/precision=single", R"(/integrator={"type":"leapfrog","courant":0.5})"};
    const Summary s = run(sounding(2, 31, set));
    CHECK(s.energy_final == Approx(s.energy_initial).epsilon(2e-6));
    set[2] = "/until=0.2";
    Case one = sounding(2, 200, set), three = sounding(2, 200, set);
    one.threads = 1, three.threads = 3;
    Simulation a(one), b(three);
    a.run(), b.run();
    CHECK(largest_difference(a.profile(), b.profile()) == 0);
}
