/// What this machine can do: finite differences as bare loops, memory traffic, arithmetic.
#include <vector>

#include "lanes.hpp"
#include "measure.hpp"

using namespace sphonic;
using namespace sphonic::benchmarks;

namespace {

/// A field of n^D values with room around it.
template <int D>
struct Grid {
    long n, row, layer, rows;
    explicit Grid(long n) : n(n), row(D > 1 ? n + 8 : 0), layer(D > 2 ? row * (n + 2) : 0), rows(D > 1 ? n : 1) {}
    std::vector<double> field() const { return std::vector<double>(std::size_t((n + 8) * (D > 1 ? n + 2 : 1) * (D > 2 ? n + 2 : 1) + 16)); }
    double points() const { return D == 1 ? double(n) : D == 2 ? double(n * n) : double(n * n * n); }
    template <class Row>
    void for_rows(Row at) const {
        for (long k = 0; k < (D > 2 ? n : 1); ++k)
            for (long j = 0; j < rows; ++j) at((k + (D > 2)) * layer + (j + (D > 1)) * row + 8);
    }
};

/// Yee's scheme: the yardstick.
template <int D>
void plain_fdtd(benchmark::State& state, long n) {
    const Grid<D> grid(n);
    std::vector<double> p = grid.field(), u = p, v = p, w = p;
    const long y = grid.row, z = grid.layer;
    for (auto _ : state) {
        grid.for_rows([&](long at) {
#pragma omp simd
            for (long i = at; i < at + n; ++i) {
                u[i] -= 0.1 * (p[i + 1] - p[i]);
                if constexpr (D > 1) v[i] -= 0.1 * (p[i + y] - p[i]);
                if constexpr (D > 2) w[i] -= 0.1 * (p[i + z] - p[i]);
            }
        });
        grid.for_rows([&](long at) {
#pragma omp simd
            for (long i = at; i < at + n; ++i) {
                double flow = u[i] - u[i - 1];
                if constexpr (D > 1) flow += v[i] - v[i - y];
                if constexpr (D > 2) flow += w[i] - w[i - z];
                p[i] -= 0.1 * flow;
            }
        });
        benchmark::ClobberMemory();
    }
    nanoseconds_per(state, "particle-step", grid.points());
    floor_of(state, {6.0 * D, 8.0 * (3 + 3 * D), 8.0 * (1 + D) * grid.points()});
}
void plain_fdtd_1d(benchmark::State& state) { plain_fdtd<1>(state, 2500); }
void plain_fdtd_2d(benchmark::State& state) { plain_fdtd<2>(state, 512); }
void plain_fdtd_3d(benchmark::State& state) { plain_fdtd<3>(state, 128); }

/// a = b + s c over three arrays of `range` values in all.
void triad(benchmark::State& state) {
    const long n = state.range(0) / 3;
    std::vector<double> a(n), b(n), c(n);
    for (auto _ : state) {
        double *__restrict to = a.data(), *__restrict from = b.data(), *__restrict added = c.data();
        benchmark::DoNotOptimize(to);
#pragma omp simd
        for (long i = 0; i < n; ++i) to[i] = from[i] + 0.5 * added[i];
        benchmark::ClobberMemory();
    }
    nanoseconds_per(state, "byte", 24.0 * double(n));
}

/// Independent multiplications with addition, in registers.
void fused_multiply_add(benchmark::State& state) {
    constexpr int chains = 8, length = 256;
    const Lane factor = Lane{} + 0.999, added = Lane{} + 1e-3;
    Lane x[chains] = {};
    for (auto _ : state) {
        for (int k = 0; k < length; ++k) {
#pragma GCC unroll 8
            for (int c = 0; c < chains; ++c) x[c] = x[c] * factor + added;
        }
        for (Lane& chain : x) benchmark::DoNotOptimize(chain);
    }
    nanoseconds_per(state, "flop", 2.0 * chains * lanes * length);
}

}    // namespace

BENCHMARK(plain_fdtd_1d);
BENCHMARK(plain_fdtd_2d);
BENCHMARK(plain_fdtd_3d);
BENCHMARK(triad)->Arg(3 << 10)->Arg(3 << 18)->Arg(3 << 23);
BENCHMARK(fused_multiply_add);
