/// The same bits for any number of threads, in every tier.
#include "sound.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

Profile end(int dimension, int n, std::vector<std::string> set, int threads, double length = 1) {
    set.push_back("/until=0.05");
    Case c = scene(periodic_box(dimension, n, length), set);
    c.threads = threads;
    Simulation simulation(c);
    CHECK(simulation.summary().threads == threads);
    simulation.run();
    return simulation.profile();
}

void same_bits(int dimension, int n, const std::vector<std::string>& set, double length = 1) {
    const Profile one = end(dimension, n, set, 1, length);
    for (const int threads : {2, 3, 7}) {
        INFO(dimension << "-D, " << threads << " threads");
        const Profile other = end(dimension, n, set, threads, length);
        CHECK(one.p == other.p);
        for (int a = 0; a < dimension; ++a) CHECK(one.x[a] == other.x[a]);
    }
}

const std::string noisy = "/initial/p=sin(40*x+r) + 0.1*cos(1e4*x)";
const std::string viscous = R"(/viscosity={"type":"monaghan","alpha":0.3})";
const std::string damped = R"(/dissipation={"type":"fourth_order","alpha":0.3})";
const std::string wide = "/kernel/h_over_dx=1.3";
const std::string walls = "/boundaries=[" + face("all", "rigid") + "]", corrected = forms("corrected", "corrected_adjoint");
const std::string source = R"(/sources=[{"type":"plane_wave","region":"x < 0.3","amplitude":1,"omega":30},
    {"type":"point","flow":1,"omega":20,"position":[0.6]}])";

}    // namespace

TEST_CASE("lattices: the same bits for any number of threads", "[threads]") {
    same_bits(1, 200, {noisy, viscous, wide, source}, 60);    // longer than a block
    same_bits(2, 33, {noisy, viscous, wide});
    same_bits(3, 11, {noisy, viscous, wide});
    same_bits(2, 33, {noisy, wide, "/boundaries=[]", "/integrator/type=rk4"});
}

TEST_CASE("frozen and moving sets: the same bits for any number of threads", "[threads]") {
    const std::string lagrangian = "/particles/motion=lagrangian", equations = "/equations=lagrangian_acoustics";
    same_bits(1, 200, {noisy, viscous, wide, source, lagrangian}, 30);
    for (int d = 1; d <= 3; ++d) {
        const int n = d == 3 ? 11 : 33;
        same_bits(d, n, {noisy, viscous, wide, "/particles/jitter=0.2"});
        same_bits(d, n, {noisy, "/particles/jitter=0.2", "/equations=band_fitted_acoustics", "/integrator/type=leapfrog", "/integrator/courant=0.4"});
        same_bits(d, n, {noisy, viscous, wide, equations, lagrangian, "/medium/rho0=900"});
        same_bits(d, n, {noisy, viscous, wide, walls, "/particles/jitter=0.2"});
        same_bits(d, n, {noisy, viscous, wide, walls, corrected, lagrangian, "/medium/rho0=900"});
        const int few = d == 3 ? 7 : 21;
        same_bits(d, few, {noisy, wide, walls, damped, "/particles/jitter=0.2"});
        same_bits(d, few, {noisy, wide, walls, damped, lagrangian, equations, "/medium/rho0=900"});
    }
}
