/// What finding neighbours anew takes of whole steps of sets that move.
#include <algorithm>
#include <numeric>
#include <vector>

#include "machine.hpp"
#include "measure.hpp"
#include "particle_system.hpp"

using namespace sphonic;
using namespace sphonic::benchmarks;

namespace {

/// A system that knows how long it took to settle after particles had moved. Each time displacements are watched and the list's pairs
/// narrowed down to those near, and now and then a list is built: what takes longer than the quickest.
class Watched final : public abi::System {
public:
    explicit Watched(const Case& scene) : system(scene) { system.initialise(1e-3); }

    int groups() const override { return system.groups(); }
    abi::Slot history(const char* name) override { return system.history(name); }
    void rate(abi::Group group, double t, abi::Slot out) override { system.rate(group, t, out); }
    void advance(abi::Group group, double t, double dt) override { system.advance(group, t, dt); }
    void copy(abi::Group group, abi::Slot from, abi::Slot to) override { system.copy(group, from, to); }
    void axpy(abi::Group group, double a, abi::Slot x, abi::Slot y) override { system.axpy(group, a, x, y); }
    void settle(abi::Group group, double t) override {
        const double begin = cpu_seconds();
        system.settle(group, t);
        if (group > 0) settled_s.push_back(cpu_seconds() - begin);    // the second half of a step moves
    }
    double narrowing_s() const { return double(settled_s.size()) * *std::ranges::min_element(settled_s); }
    double rebuilding_s() const { return std::accumulate(settled_s.begin(), settled_s.end(), -narrowing_s()); }

    ParticleSystem system;
    std::vector<double> settled_s{};
    long steps = 0;
};

/// Goes on from one repetition to the next.
void rebuilding(benchmark::State& state, Case from) {
    auto& [scene, watched] = prepare<Watched>(std::move(from));
    const double dt = 0.3 * scene.box.dx;    // c0 dt = 0.23 h
    const auto step = [&] {
        const long index = watched.steps++;
        scene.integrator->step(watched, {index, double(index) * dt, dt});
    };
    while (watched.steps < 20) step();    // until lists have found their width
    watched.settled_s.clear();
    const double begin = cpu_seconds();
    for (auto _ : state) step();
    const double all = cpu_seconds() - begin;
    state.counters["rebuilding"] = watched.rebuilding_s() / all;
    state.counters["narrowing"] = watched.narrowing_s() / all;
    nanoseconds_per(state, "pair", double(watched.system.particles()) * watched.system.neighbours_mean());
}

/// n^d particles in a box that repeats.
Case torus(int dimension, int n, std::vector<std::string> set) {
    const std::vector<int> upper(std::size_t(dimension), n);
    set.push_back("/particles/upper=" + Json(upper).dump());
    set.push_back(R"(/boundaries=[{"type":"periodic","face":"all"}])");
    return lattice(dimension, n, 1.3, set);
}

/// Vortices of a tenth of the sound's speed, as a flow that is meant to be weakly compressible has them: particles pass each other for good.
const std::string vortices = R"json(/initial={"u":["0.1*sin(2*pi*x/32)*cos(2*pi*y/32)","-0.1*cos(2*pi*x/32)*sin(2*pi*y/32)")json";
/// Sound so loud that particles move by a spacing and back.
const std::string loud = R"json(/initial={"p":"0.1*sin(2*pi*x/32)"})json";
std::vector<std::string> moving(const std::string& initial) { return {monaghan, "/particles/motion=lagrangian", "/equations=lagrangian_acoustics", initial}; }

void rebuilding_vortices_2d(benchmark::State& state) { rebuilding(state, torus(2, 256, moving(vortices + "]}"))); }
void rebuilding_vortices_3d(benchmark::State& state) { rebuilding(state, torus(3, 32, moving(vortices + R"(,"0"]})"))); }
void rebuilding_standing_wave_2d(benchmark::State& state) { rebuilding(state, torus(2, 256, moving(loud))); }
void rebuilding_standing_wave_3d(benchmark::State& state) { rebuilding(state, torus(3, 32, moving(loud))); }

}    // namespace

BENCHMARK(rebuilding_vortices_2d)->Iterations(20);
BENCHMARK(rebuilding_vortices_3d)->Iterations(20);
BENCHMARK(rebuilding_standing_wave_2d)->Iterations(20);
BENCHMARK(rebuilding_standing_wave_3d)->Iterations(20);
