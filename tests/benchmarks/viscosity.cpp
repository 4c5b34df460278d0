/// What the plugin's door costs: the lattice's viscosity term through the Monaghan plugin against the same loop with the
/// formula written into it. Same blocks, same folding, same lattice, one process.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "lattice_operators.hpp"
#include "scenes.hpp"

using namespace sphonic;
using namespace sphonic::benchmarks;

namespace {

constexpr int particles = 2500;

/// One line of particles with all that the term needs, outside any solver.
struct Line {
    Case scene = lattice(1, particles, 3.25, {monaghan});
    Components components{scene};
    ParticleMedia media{scene, 0, nullptr};
    LatticeGrid grid{scene, media, 6};
    std::vector<Array> fields;
    std::vector<const double*> state;
    std::vector<double*> out;
    Array result;
    int velocity;

    Line() {
        velocity = components.first[std::size_t(scene.equations.find("u"))];
        result = Array(std::size_t(grid.layout.size));
        out.assign(std::size_t(components.count), result.data());
        for (int c = 0; c < components.count; ++c) {
            fields.emplace_back(std::size_t(grid.layout.size));
            for (long i = 0; i < particles; ++i) fields.back().data()[grid.layout.origin + i] = std::sin(0.01 * double(i));
            state.push_back(fields.back().data());
        }
    }
    const Term& term() const {
        for (const Term& t : scene.equations.variables[std::size_t(scene.equations.find("u"))].terms)
            if (t.viscosity) return t;
        throw std::logic_error("no viscosity");
    }
};

void viscosity_by_plugin(benchmark::State& state) {
    Line line;
    const auto op = make_lattice_term<double>(line.grid, line.components, line.term(), {line.velocity});
    for (auto _ : state) {
        op->apply({line.state.data(), line.out.data(), 1, true});
        benchmark::ClobberMemory();
    }
}

void viscosity_inline(benchmark::State& state) {
    Line line;
    constexpr long block = 512, reach = 8;
    struct Pair {
        long o;
        double r, weight, linear, quadratic;
    };
    std::vector<Pair> pairs;
    const double h = line.scene.kernels[0].h, alpha = 0.06, beta = 0.5;
    for (const Offset& n : half_neighbours(line.grid.neighbours[0])) {
        const double width = n.r2 + 0.01 * h * h;
        pairs.push_back({n.o[0], -double(n.o[0]), -n.gradient[0], -alpha * h / width, beta * h * h / (width * width)});
    }
    const double* u = line.state[std::size_t(line.velocity)] + line.grid.layout.origin;
    double* out = line.result.data() + line.grid.layout.origin;
    for (auto _ : state) {
        for (long begin = 0; begin < particles; begin += block) {
            const long end = std::min<long>(begin + block, particles);
            double sum[block] = {}, Pi[block + reach];
            for (const Pair& pair : pairs) {
                const long first = std::max(begin - pair.o, 0L), last = std::min(end, particles - pair.o);
#pragma omp simd
                for (long i = first; i < last; ++i) {
                    const double s = std::min((u[i] - u[i + pair.o]) * pair.r, 0.0);
                    Pi[i - first] = (pair.linear + pair.quadratic * s) * s;
                }
                for (long i = std::max(begin, first); i < last; ++i) sum[i - begin] += pair.weight * Pi[i - first];
                for (long i = std::max(begin, first + pair.o); i < std::min(end, last + pair.o); ++i)
                    sum[i - begin] -= pair.weight * Pi[i - pair.o - first];
            }
            for (long i = begin; i < end; ++i) out[i] = sum[i - begin];
        }
        benchmark::ClobberMemory();
    }
}

}    // namespace

BENCHMARK(viscosity_by_plugin);
BENCHMARK(viscosity_inline);
BENCHMARK_MAIN();
