/// Lattices of a thousand to ten million particles: what a particle-step costs in each level of memory.
#include "measure.hpp"

using namespace sphonic;
using namespace sphonic::benchmarks;

namespace {

void lattice_2d_size(benchmark::State& state) { steps(state, lattice(2, int(state.range(0)), 1.3)); }
void lattice_3d_size(benchmark::State& state) { steps(state, lattice(3, int(state.range(0)), 1.3)); }

}    // namespace

BENCHMARK(lattice_2d_size)->Arg(32)->Arg(100)->Arg(316)->Arg(1000)->Arg(3162);
BENCHMARK(lattice_3d_size)->Arg(10)->Arg(22)->Arg(46)->Arg(100)->Arg(215);
