/// Sets without a stencil, frozen and moving: whole steps, and the halves of a frozen one, as nanoseconds per pair.
#include "measure.hpp"
#include "particle_system.hpp"

using namespace sphonic;
using namespace sphonic::benchmarks;

namespace {

const std::string jitter = "/particles/jitter=0.2", lagrangian = "/particles/motion=lagrangian";

struct Started {
    ParticleSystem system;
    explicit Started(const Case& scene) : system(scene) { system.initialise(1e-3); }
};

/// One half of a step, the first (momentum) or the second (pressure), by a step so short that nothing changes.
void half_step(benchmark::State& state, abi::Group group, Case from) {
    auto& [scene, started] = prepare<Started>(std::move(from));
    ParticleSystem& system = started.system;
    for (auto _ : state) system.advance(group, 0, 1e-9);
    const double pairs = double(system.particles()) * system.neighbours_mean();
    nanoseconds_per(state, "pair", pairs);
    state.counters["neighbours"] = system.neighbours_mean();
    const int d = scene.box.dimension;
    floor_of(state, {2.0 * d, 4 + 8.0 * d, (4 + 8.0 * d) * pairs});
}

/// Momentum and pressure of a moving set at the same positions.
void both_sides(benchmark::State& state, Case from) {
    ParticleSystem& system = prepare<Started>(std::move(from)).made.system;
    const abi::Slot out = system.history("benchmark");
    for (auto _ : state) system.rate(abi::everything, 0, out);
    nanoseconds_per(state, "pair", double(system.particles()) * system.neighbours_mean());
    state.counters["neighbours"] = system.neighbours_mean();
}

void frozen_1d(benchmark::State& state) { steps(state, lattice(1, 2500, 3.25, {jitter})); }
void frozen_2d(benchmark::State& state) { steps(state, lattice(2, 512, 1.3, {jitter})); }
void frozen_2d_monaghan(benchmark::State& state) { steps(state, lattice(2, 512, 1.3, {jitter, monaghan})); }
void frozen_2d_gradient(benchmark::State& state) { half_step(state, 0, lattice(2, 512, 1.3, {jitter})); }
void frozen_2d_divergence(benchmark::State& state) { half_step(state, 1, lattice(2, 512, 1.3, {jitter})); }
void frozen_2d_momentum_monaghan(benchmark::State& state) { half_step(state, 0, lattice(2, 512, 1.3, {jitter, monaghan})); }
void frozen_3d(benchmark::State& state) { steps(state, lattice(3, 48, 1.3, {jitter})); }
void frozen_3d_gradient(benchmark::State& state) { half_step(state, 0, lattice(3, 48, 1.3, {jitter})); }
void frozen_3d_divergence(benchmark::State& state) { half_step(state, 1, lattice(3, 48, 1.3, {jitter})); }
void frozen_3d_momentum_monaghan(benchmark::State& state) { half_step(state, 0, lattice(3, 48, 1.3, {jitter, monaghan})); }

void moving_1d_monaghan(benchmark::State& state) { steps(state, lattice(1, 2500, 3.25, {monaghan, lagrangian})); }
void moving_2d_monaghan(benchmark::State& state) { steps(state, lattice(2, 256, 1.3, {monaghan, lagrangian})); }
void moving_3d_monaghan(benchmark::State& state) { steps(state, lattice(3, 40, 1.3, {monaghan, lagrangian})); }
void moving_2d(benchmark::State& state) { steps(state, lattice(2, 256, 1.3, {lagrangian})); }
void moving_3d(benchmark::State& state) { steps(state, lattice(3, 40, 1.3, {lagrangian})); }
void moving_2d_both_sides_monaghan(benchmark::State& state) { both_sides(state, lattice(2, 256, 1.3, {monaghan, lagrangian})); }
void moving_3d_both_sides_monaghan(benchmark::State& state) { both_sides(state, lattice(3, 40, 1.3, {monaghan, lagrangian})); }
const std::string densities = "/equations=lagrangian_acoustics";
void moving_2d_both_sides_densities_monaghan(benchmark::State& state) { both_sides(state, lattice(2, 256, 1.3, {monaghan, lagrangian, densities})); }
void moving_3d_both_sides_densities_monaghan(benchmark::State& state) { both_sides(state, lattice(3, 40, 1.3, {monaghan, lagrangian, densities})); }

}    // namespace

BENCHMARK(frozen_1d);
BENCHMARK(frozen_2d);
BENCHMARK(frozen_2d_monaghan);
BENCHMARK(frozen_2d_gradient);
BENCHMARK(frozen_2d_divergence);
BENCHMARK(frozen_2d_momentum_monaghan);
BENCHMARK(frozen_3d);
BENCHMARK(frozen_3d_gradient);
BENCHMARK(frozen_3d_divergence);
BENCHMARK(frozen_3d_momentum_monaghan);
BENCHMARK(moving_1d_monaghan);
BENCHMARK(moving_2d_monaghan);
BENCHMARK(moving_3d_monaghan);
BENCHMARK(moving_2d);
BENCHMARK(moving_3d);
BENCHMARK(moving_2d_both_sides_monaghan);
BENCHMARK(moving_3d_both_sides_monaghan);
BENCHMARK(moving_2d_both_sides_densities_monaghan);
BENCHMARK(moving_3d_both_sides_densities_monaghan);
