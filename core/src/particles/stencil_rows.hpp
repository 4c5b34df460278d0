#pragma once
/// The inner loops of the lattice tier: antisymmetric stencils over one row of particles, in registers.

#include <cstddef>
#include <vector>

#include "lanes.hpp"

namespace sphonic {

/// A folded pair of neighbours: out_a += weight[a] * (f[i + at] - f[i - at]).
template <class Real>
struct FoldedPair {
    std::ptrdiff_t at;
    Real weight[3];
};

/// One component's share of a divergence: out += weight * (f[i + at] - f[i - at]).
template <class Real>
struct FoldedTap {
    std::ptrdiff_t at;
    Real weight;
};

/// Gradient of one field: D sums of `V` vectors each, kept in registers over all pairs.
template <class Real, int D, int V>
inline void gradient_block(const Real* f, const std::vector<FoldedPair<Real>>& pairs, LaneOf<Real> (&sum)[D][V]) {
    constexpr int lanes = lanes_of<Real>;
    for (int a = 0; a < D; ++a)
        for (int v = 0; v < V; ++v) sum[a][v] = LaneOf<Real>{};
    for (const FoldedPair<Real>& pair : pairs) {
        const Real *ahead = f + pair.at, *behind = f - pair.at;
        LaneOf<Real> difference[V];
#pragma GCC unroll 8
        for (int v = 0; v < V; ++v) difference[v] = load(ahead + v * lanes) - load(behind + v * lanes);
#pragma GCC unroll 3
        for (int a = 0; a < D; ++a)
#pragma GCC unroll 8
            for (int v = 0; v < V; ++v) sum[a][v] += pair.weight[a] * difference[v];
    }
}

/// Divergence of D fields: one sum of `V` vectors.
template <class Real, int D, int V>
inline void divergence_block(const Real* const* f, std::ptrdiff_t i, const std::vector<FoldedTap<Real>>* taps, LaneOf<Real> (&sum)[1][V]) {
    constexpr int lanes = lanes_of<Real>;
    for (int v = 0; v < V; ++v) sum[0][v] = LaneOf<Real>{};
    for (int a = 0; a < D; ++a) {
        const Real* field = f[a] + i;
        for (const FoldedTap<Real>& tap : taps[a]) {
            const Real *ahead = field + tap.at, *behind = field - tap.at;
#pragma GCC unroll 8
            for (int v = 0; v < V; ++v) sum[0][v] += tap.weight * (load(ahead + v * lanes) - load(behind + v * lanes));
        }
    }
}

/// What becomes of a block of sums: out[a] = scale * sum, or out[a] += scale * sum.
template <class Real>
struct Finish {
    Real scale;
    bool assign;
};

template <class Real, int D, int V>
inline void finish_block(const LaneOf<Real> (&sum)[D][V], const Finish<Real>& finish, Real* const* out, std::ptrdiff_t i) {
    for (int a = 0; a < D; ++a)
        for (int v = 0; v < V; ++v) {
            Real* target = out[a] + i + v * lanes_of<Real>;
            const LaneOf<Real> value = finish.scale * sum[a][v];
            store(target, finish.assign ? value : load(target) + value);
        }
}

/// The last particles of a row, fewer than a vector.
template <class Real, int D>
inline void finish_part(const LaneOf<Real> (&sum)[D][1], const Finish<Real>& finish, Real* const* out, std::ptrdiff_t i, long n) {
    for (int a = 0; a < D; ++a) {
        Real values[lanes_of<Real>];
        store(values, LaneOf<Real>(finish.scale * sum[a][0]));
        for (long k = 0; k < n; ++k) out[a][i + k] = finish.assign ? values[k] : out[a][i + k] + values[k];
    }
}

/// Runs `block(i, sum)` over a row of n particles that starts at `offset`, wide blocks first.
/// Reads beyond the row stay inside the padding that the layout leaves.
template <int D, int Wide, class Real, class Block>
inline void sweep_row(std::ptrdiff_t offset, long n, const Finish<Real>& finish, Real* const* out, Block block) {
    constexpr int lanes = lanes_of<Real>;
    long i = 0;
    for (; i + Wide * lanes <= n; i += Wide * lanes) {
        LaneOf<Real> sum[D][Wide];
        block(offset + i, sum);
        finish_block<Real, D, Wide>(sum, finish, out, offset + i);
    }
    for (; i < n; i += lanes) {
        LaneOf<Real> sum[D][1];
        block(offset + i, sum);
        if (i + lanes <= n)
            finish_block<Real, D, 1>(sum, finish, out, offset + i);
        else
            finish_part<Real, D>(sum, finish, out, offset + i, n - i);
    }
}

}    // namespace sphonic
