#pragma once
/// The inner loops of the lattice tier: antisymmetric stencils over one row of particles, in registers.

#include <cstddef>
#include <vector>

#include "lanes.hpp"

namespace sphonic {

/// A folded pair of neighbours: out_a += weight[a] * (f[i + at] - f[i - at]).
struct FoldedPair {
    std::ptrdiff_t at;
    double weight[3];
};

/// One component's share of a divergence: out += weight * (f[i + at] - f[i - at]).
struct FoldedTap {
    std::ptrdiff_t at;
    double weight;
};

/// Gradient of one field: D sums of `V` vectors each, kept in registers over all pairs.
template <int D, int V>
inline void gradient_block(const double* f, const FoldedPair* pairs, std::size_t count, Lane (&sum)[D][V]) {
    for (int a = 0; a < D; ++a)
        for (int v = 0; v < V; ++v) sum[a][v] = Lane{};
    for (const FoldedPair* pair = pairs; pair != pairs + count; ++pair) {
        const double *ahead = f + pair->at, *behind = f - pair->at;
        Lane difference[V];
#pragma GCC unroll 8
        for (int v = 0; v < V; ++v) difference[v] = load(ahead + v * lanes) - load(behind + v * lanes);
#pragma GCC unroll 3
        for (int a = 0; a < D; ++a)
#pragma GCC unroll 8
            for (int v = 0; v < V; ++v) sum[a][v] += pair->weight[a] * difference[v];
    }
}

/// Divergence of D fields: one sum of `V` vectors.
template <int D, int V>
inline void divergence_block(const double* const* f, std::ptrdiff_t i, const std::vector<FoldedTap>* taps, Lane (&sum)[1][V]) {
    for (int v = 0; v < V; ++v) sum[0][v] = Lane{};
    for (int a = 0; a < D; ++a) {
        const double* field = f[a] + i;
        for (const FoldedTap& tap : taps[a]) {
            const double *ahead = field + tap.at, *behind = field - tap.at;
#pragma GCC unroll 8
            for (int v = 0; v < V; ++v) sum[0][v] += tap.weight * (load(ahead + v * lanes) - load(behind + v * lanes));
        }
    }
}

/// What becomes of a block of sums: out[a] = scale * sum, or out[a] += scale * sum.
struct Finish {
    double scale;
    bool assign;
};

template <int D, int V>
inline void finish_block(const Lane (&sum)[D][V], const Finish& finish, double* const* out, std::ptrdiff_t i) {
    for (int a = 0; a < D; ++a)
        for (int v = 0; v < V; ++v) {
            double* target = out[a] + i + v * lanes;
            const Lane value = finish.scale * sum[a][v];
            store(target, finish.assign ? value : load(target) + value);
        }
}

/// The last particles of a row, fewer than a vector.
template <int D>
inline void finish_part(const Lane (&sum)[D][1], const Finish& finish, double* const* out, std::ptrdiff_t i, long n) {
    for (int a = 0; a < D; ++a) {
        double values[lanes];
        store(values, finish.scale * sum[a][0]);
        for (long k = 0; k < n; ++k) out[a][i + k] = finish.assign ? values[k] : out[a][i + k] + values[k];
    }
}

/// Runs `block<V>(i, sum)` over a row of n particles that starts at `offset`, wide blocks first.
/// Reads beyond the row stay inside the padding that the layout leaves.
template <int D, int Wide, class Block>
inline void sweep_row(std::ptrdiff_t offset, long n, const Finish& finish, double* const* out, Block block) {
    long i = 0;
    for (; i + Wide * lanes <= n; i += Wide * lanes) {
        Lane sum[D][Wide];
        block(offset + i, sum);
        finish_block(sum, finish, out, offset + i);
    }
    for (; i < n; i += lanes) {
        Lane sum[D][1];
        block(offset + i, sum);
        if (i + lanes <= n)
            finish_block(sum, finish, out, offset + i);
        else
            finish_part(sum, finish, out, offset + i, n - i);
    }
}

}    // namespace sphonic
