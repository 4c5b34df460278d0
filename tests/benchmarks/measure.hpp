#pragma once
/// What all timings share: CPU time per unit of work, and a set that is prepared once for all repetitions.
#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <string>

#include <sphonic/prediction.hpp>
#include <sphonic/simulation.hpp>

#include "scenes.hpp"

namespace sphonic::benchmarks {

/// CPU time per unit as nanoseconds, `units` of them in one iteration.
inline void nanoseconds_per(benchmark::State& state, const std::string& unit, double units) {
    state.counters["ns/" + unit] = benchmark::Counter(1e-9 * units, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// What no program can do without: arithmetic and memory traffic of one unit of work.
struct Floor {
    double flops, bytes;
    double footprint;    ///< [bytes] of all that one iteration touches
};
inline void floor_of(benchmark::State& state, const Floor& floor) {
    state.counters["flops"] = floor.flops;
    state.counters["bytes"] = floor.bytes;
    state.counters["footprint"] = floor.footprint;
}

/// A case and what was made of it, kept for the repetitions to come.
template <class Made>
struct Prepared {
    Case scene;
    Made made;
    explicit Prepared(Case from) : scene(std::move(from)), made(scene) {}
};
template <class Made>
Prepared<Made>& prepare(Case scene) {
    static std::map<std::string, std::unique_ptr<Prepared<Made>>> all;
    auto& kept = all[scene.resolved->dump()];
    if (!kept) kept = std::make_unique<Prepared<Made>>(std::move(scene));
    return *kept;
}

/// Fields read and written once in each half of a step; on a lattice one multiplication and addition for each weight that
/// symmetry leaves distinct, for gradient and divergence.
inline Floor floor_of(const Case& scene, const Summary& summary) {
    const int d = scene.box.dimension;
    const bool lattice = summary.tier == "lattice";
    return {lattice ? 4.0 * distinct_weights(scene) : 0, 8.0 * (3 + 3 * d), 8.0 * (1 + d) * double(summary.particles)};
}

/// Whole steps of a case. Their number goes on from one repetition to the next.
inline void steps(benchmark::State& state, Case from) {
    auto& [scene, simulation] = prepare<Simulation>(std::move(from));
    abi::Solver& solver = simulation.solver();
    for (auto _ : state) solver.step();
    const Summary& summary = simulation.summary();
    nanoseconds_per(state, "particle-step", double(summary.particles));
    nanoseconds_per(state, "pair", double(summary.particles) * summary.neighbours_mean);
    state.counters["neighbours"] = summary.neighbours_mean;
    state.counters["predicted"] = 1e9 * predict(scene, summary).cpu_s / (double(summary.particles) * double(summary.steps));
    floor_of(state, floor_of(scene, summary));
}

}    // namespace sphonic::benchmarks
