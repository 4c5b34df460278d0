/// Whole steps on lattices and of the methods without particles, as nanoseconds per particle-step.
#include <vector>

#include "lattice_ghosts.hpp"
#include "measure.hpp"

using namespace sphonic;
using namespace sphonic::benchmarks;

namespace {

void lattice_1d(benchmark::State& state) { steps(state, lattice(1, 2500, 3.25)); }
void lattice_1d_monaghan(benchmark::State& state) { steps(state, lattice(1, 2500, 3.25, {monaghan})); }
void lattice_1d_h_equals_dx(benchmark::State& state) { steps(state, lattice(1, 2500, 1)); }
void lattice_2d(benchmark::State& state) { steps(state, lattice(2, 512, 1.3)); }
void lattice_2d_monaghan(benchmark::State& state) { steps(state, lattice(2, 512, 1.3, {monaghan})); }
const std::string rigid = R"(/boundaries=[{"type":"rigid","face":"all"}])";
void lattice_2d_walls(benchmark::State& state) { steps(state, lattice(2, 512, 1.3, {rigid})); }
void lattice_2d_walls_corrected(benchmark::State& state) { steps(state, lattice(2, 512, 1.3, {rigid, "/equations=corrected_acoustics"})); }
void lattice_2d_walls_two_media(benchmark::State& state) {
    steps(state, lattice(2, 512, 1.3, {rigid, "/equations=acoustics", R"(/medium=[{"c0":1,"rho0":1},{"c0":2,"rho0":3,"region":"x + y/3 > 300"}])"}));
}

const std::string single = "/precision=single";
void lattice_1d_single(benchmark::State& state) { steps(state, lattice(1, 2500, 3.25, {single})); }
void lattice_2d_single(benchmark::State& state) { steps(state, lattice(2, 512, 1.3, {single})); }
void lattice_3d_single(benchmark::State& state) { steps(state, lattice(3, 128, 1.3, {single})); }

/// What fills the ghosts of the three fields of lattice_2d_walls: a part of its step.
void ghosts_2d(benchmark::State& state) {
    const Case scene = lattice(2, 512, 1.3, {rigid});
    const Components components(scene);
    const ParticleMedia media(scene, 0, nullptr);
    const Layout layout = Layout::grid(scene.box, 2);
    const LatticeTiles tiles(scene.box, layout);
    LatticeGhosts ghosts(scene, components, media, layout, tiles, 1);
    std::vector<Array> fields;
    for (int c = 0; c < components.count; ++c) fields.emplace_back(std::size_t(layout.size));
    for (auto _ : state) {
        for (int c = 0; c < components.count; ++c) ghosts.fill(c, fields[std::size_t(c)].data(), fields[0].data(), 0);
        benchmark::ClobberMemory();
    }
    nanoseconds_per(state, "particle-step", 512. * 512);
}
void lattice_3d(benchmark::State& state) { steps(state, lattice(3, 128, 1.3)); }
void lattice_3d_monaghan(benchmark::State& state) { steps(state, lattice(3, 64, 1.3, {monaghan})); }
/// A pulse in the middle of a box ten times as large as it is at the end of a dozen steps, in nanoseconds per nominal particle-step.
void lattice_3d_pulse(benchmark::State& state, const std::string& active) {
    const Case scene = lattice(3, 161, 1.3, {R"json(/initial/p=1e-6*exp(-((x-80)^2+(y-80)^2+(z-80)^2)/4))json", "/integrator/courant=0.4", "/until=4.8", "/active=" + active});
    double nominal = 1;
    for (auto _ : state) {
        state.PauseTiming();
        auto simulation = std::make_unique<Simulation>(scene);
        const Summary& s = simulation->summary();
        nominal = double(s.particles) * double(s.steps);
        state.ResumeTiming();
        for (long step = 0; step < s.steps; ++step) simulation->solver().step();
        state.PauseTiming();
        const double stepped = simulation->solver().activity().particle_steps;
        state.counters["stepped"] = stepped < 0 ? 1 : stepped / nominal;
        simulation.reset();
        state.ResumeTiming();
    }
    nanoseconds_per(state, "particle-step", nominal);
}
void lattice_3d_pulse_all(benchmark::State& state) { lattice_3d_pulse(state, "all"); }
void lattice_3d_pulse_asleep(benchmark::State& state) { lattice_3d_pulse(state, "auto"); }
void fdtd_1d(benchmark::State& state) { steps(state, lattice(1, 2500, 1, {R"(/method={"type":"fdtd"})"})); }
void fdtd_2d(benchmark::State& state) { steps(state, lattice(2, 512, 1, {R"(/method={"type":"fdtd"})"})); }
/// What acts between the halves of a step parts them.
const std::string circle = R"(/obstacles=[{"type":"circle","centre":[250,260],"radius":60}])", tone = R"(/sources=[{"type":"point","position":[100,100],"omega":0.3}])";
const std::string layers = R"(/boundaries=[{"type":"absorbing_layer","face":"all","thickness":20,"attenuation":60}])";
void fdtd_2d_bodies(benchmark::State& state) { steps(state, lattice(2, 512, 1, {R"(/method={"type":"fdtd"})", circle})); }
void fdtd_2d_layers(benchmark::State& state) { steps(state, lattice(2, 512, 1, {R"(/method={"type":"fdtd"})", layers})); }
void fdtd_2d_source(benchmark::State& state) { steps(state, lattice(2, 512, 1, {R"(/method={"type":"fdtd"})", tone})); }
void fdtd_2d_order_4(benchmark::State& state) { steps(state, lattice(2, 512, 1, {R"(/method={"type":"fdtd","order":4})"})); }
const std::string periodic = R"(/boundaries=[{"type":"periodic","face":"all"}])", full = "/particles/upper=[512,512]", kspace = R"(/method={"type":"kspace"})";
void kspace_2d(benchmark::State& state) { steps(state, lattice(2, 512, 1, {kspace, periodic, full})); }
void kspace_2d_two_media(benchmark::State& state) {
    steps(state, lattice(2, 512, 1, {kspace, periodic, full, R"(/medium=[{"c0":1,"rho0":1},{"c0":2,"rho0":3,"region":"x + y/3 > 300"}])"}));
}
void fdtd_3d(benchmark::State& state) { steps(state, lattice(3, 128, 1, {R"(/method={"type":"fdtd"})"})); }

}    // namespace

BENCHMARK(lattice_1d);
BENCHMARK(lattice_1d_monaghan);
BENCHMARK(lattice_1d_h_equals_dx);
BENCHMARK(lattice_2d);
BENCHMARK(lattice_2d_monaghan);
BENCHMARK(lattice_1d_single);
BENCHMARK(lattice_2d_single);
BENCHMARK(lattice_3d_single);
BENCHMARK(lattice_2d_walls);
BENCHMARK(lattice_2d_walls_corrected);
BENCHMARK(lattice_2d_walls_two_media);
BENCHMARK(ghosts_2d);
BENCHMARK(lattice_3d);
BENCHMARK(lattice_3d_monaghan);
BENCHMARK(lattice_3d_pulse_all)->Iterations(1);
BENCHMARK(lattice_3d_pulse_asleep)->Iterations(1);
BENCHMARK(fdtd_1d);
BENCHMARK(fdtd_2d);
BENCHMARK(fdtd_2d_bodies);
BENCHMARK(fdtd_2d_layers);
BENCHMARK(fdtd_2d_source);
BENCHMARK(fdtd_2d_order_4);
BENCHMARK(fdtd_3d);
BENCHMARK(kspace_2d);
BENCHMARK(kspace_2d_two_media);
BENCHMARK_MAIN();
