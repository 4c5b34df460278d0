#pragma once
/// A stencil across and along a row of particles with every row loaded once per vector: what it gathers across the row stays in
/// registers while it slides along.

#include <utility>

#include "lanes.hpp"
#include "sliding_stencil.hpp"
#include "stencil_rows.hpp"

namespace sphonic {

/// True where there are registers for the columns of three vectors: 32 of 512 bits.
#ifdef __AVX512F__
inline constexpr bool columns_fit = true;
#else
inline constexpr bool columns_fit = false;
#endif

/// Columns A_1 ... A_R and E sets of columns B_0 ... B_R at V vectors of places.
template <class Real, int R, int E, int V>
struct Gathered {
    using Lane = LaneOf<Real>;
    static constexpr int lanes = lanes_of<Real>;
    Lane odd[R][V] = {};
    Lane even[E][R + 1][V] = {};

    [[gnu::always_inline]] Gathered(const SlidingStencil<Real>& stencil, const Real* const* f, std::ptrdiff_t i) {
        add<true, true>(stencil.both, f, i);
        add<true, false>(stencil.sums, f, i);
        add<false, true>(stencil.differences, f, i);
    }

private:
    /// Rows that are summed, subtracted, or both: of a divergence those of u_x, those of the others; of a gradient all.
    template <bool sums, bool differences>
    [[gnu::always_inline]] void add(const std::vector<typename SlidingStencil<Real>::Row>& rows, const Real* const* f, std::ptrdiff_t i) {
        for (const auto& row : rows) {
            const Real *ahead = f[row.component] + i + row.at, *behind = f[row.component] + i - row.at;
#pragma GCC unroll 2
            for (int v = 0; v < V; ++v) {
                const Lane a = load(ahead + v * lanes), b = load(behind + v * lanes), sum = a + b, difference = a - b;
#pragma GCC unroll 4
                for (int s = 0; sums && s < R; ++s) odd[s][v] += row.odd[s] * sum;
#pragma GCC unroll 2
                for (int e = 0; differences && e < E; ++e)
#pragma GCC unroll 5
                    for (int s = 0; s <= R; ++s) even[e][s][v] += row.even[e][s] * difference;
            }
        }
    }
};

/// The values from place S of two consecutive vectors on.
template <int S>
inline LaneOf<double> shifted(LaneOf<double> a, LaneOf<double> b) {
    return __builtin_shufflevector(a, b, S, S + 1, S + 2, S + 3, S + 4, S + 5, S + 6, S + 7);
}
template <int S>
inline LaneOf<float> shifted(LaneOf<float> a, LaneOf<float> b) {
    return __builtin_shufflevector(a, b, S, S + 1, S + 2, S + 3, S + 4, S + 5, S + 6, S + 7, S + 8, S + 9, S + 10, S + 11, S + 12, S + 13, S + 14, S + 15);
}

template <class Real, int R, int E, bool gradient>
class SlidingRow {
public:
    using Lane = LaneOf<Real>;
    static constexpr int lanes = lanes_of<Real>;
    static constexpr int columns = R + E * (R + 1), outputs = gradient ? 1 + E : 1;
    static constexpr int V = 5 * columns <= 25 ? 2 : 1;    ///< vectors at a time, so that all columns stay in registers
    using Window = Gathered<Real, R, E, V>;

    /// From afar, what the next row is the first to read and to write is fetched meanwhile: no prefetcher follows so many rows.
    static void apply(const SlidingStencil<Real>& stencil, const Real* const* f, std::ptrdiff_t offset, long n, const Finish<Real>& finish, Real* const* out) {
        Window behind(stencil, f, offset - V * lanes), here(stencil, f, offset);
        for (long i = 0; i < n; i += V * lanes) {
            const Window ahead(stencil, f, offset + i + V * lanes);
            for (int v = 0; stencil.far && v < V; ++v) fetch_next(stencil, f, offset + i + v * lanes, out);
#pragma GCC unroll 2
            for (int v = 0; v < V; ++v) {
                const Step step{behind, here, ahead, v};
                Lane sum[outputs][1] = {};
                sum[0][0] = step.odd(std::make_integer_sequence<int, R>());
#pragma GCC unroll 2
                for (int e = 0; e < E; ++e) sum[gradient ? 1 + e : 0][0] += step.even(e, std::make_integer_sequence<int, R>());
                const long left = n - i - v * lanes;
                if (left >= lanes)
                    finish_block<Real, outputs, 1>(sum, finish, out, offset + i + v * lanes);
                else if (left > 0)
                    finish_part<Real, outputs>(sum, finish, out, offset + i + v * lanes, left);
            }
            behind = here;
            here = ahead;
        }
    }

private:
    [[gnu::always_inline]] static void fetch_next(const SlidingStencil<Real>& stencil, const Real* const* f, std::ptrdiff_t i, Real* const* out) {
        for (int c = 0; c < stencil.components; ++c) __builtin_prefetch(f[c] + i + stencil.next);
#pragma GCC unroll 3
        for (int o = 0; o < outputs; ++o) __builtin_prefetch(out[o] + i + stencil.next_own, 1);
    }

    struct Step {
        const Window &behind, &here, &ahead;
        int v;

        /// sum_s A_s(i + s) - A_s(i - s)
        template <int... S>
        [[gnu::always_inline]] Lane odd(std::integer_sequence<int, S...>) const {
            return (about<S + 1>(behind.odd[S], here.odd[S], ahead.odd[S], -1) + ...);
        }
        /// B_0(i) + sum_s B_s(i + s) + B_s(i - s)
        template <int... S>
        [[gnu::always_inline]] Lane even(int e, std::integer_sequence<int, S...>) const {
            return here.even[e][0][v] + (about<S + 1>(behind.even[e][S + 1], here.even[e][S + 1], ahead.even[e][S + 1], 1) + ...);
        }
        template <int S>
        [[gnu::always_inline]] Lane about(const Lane* before, const Lane* at, const Lane* after, int sign) const {
            const Lane next = shifted<S>(at[v], v + 1 < V ? at[v + 1] : after[0]), last = shifted<lanes - S>(v > 0 ? at[v - 1] : before[V - 1], at[v]);
            return sign > 0 ? next + last : next - last;
        }
    };
};

}    // namespace sphonic
