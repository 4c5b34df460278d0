#pragma once
/// A stencil across and along a row of particles with every row loaded once per vector: what it gathers across the row stays in
/// registers while it slides along.

#include <utility>

#include "lanes.hpp"
#include "sliding_stencil.hpp"
#include "stencil_rows.hpp"

namespace sphonic {

/// True where there are registers for the columns of two vectors: 32 of 512 bits.
#ifdef __AVX512F__
inline constexpr bool columns_fit = true;
#else
inline constexpr bool columns_fit = false;
#endif

/// Columns A_1 ... A_R and sets of columns B_0 ... B_R at one vector of places: of a gradient a set for each of d/dy and d/dz, of a
/// divergence one for both.
template <class Real, int D, int R, bool gradient>
struct Columns {
    using Lane = LaneOf<Real>;
    using Stencil = SlidingStencil<Real>;
    using Rows = typename Stencil::Rows;
    using Beside = typename Stencil::Beside;
    static constexpr int sets = gradient ? D - 1 : 1;
    Lane odd[R] = {};
    Lane even[sets][R + 1] = {};

    [[gnu::always_inline]] Columns(const Stencil& stencil, const Real* const* f, std::ptrdiff_t i) {
        add(stencil, f, i, std::make_integer_sequence<int, R + 1>());
    }

private:
    template <int... S>
    [[gnu::always_inline]] void add(const Stencil& stencil, const Real* const* f, std::ptrdiff_t i, std::integer_sequence<int, S...>) {
        (add_reaching<S>(stencil, f, i), ...);
    }

    /// Rows that reach S particles along x.
    template <int S>
    [[gnu::always_inline]] void add_reaching(const Stencil& stencil, const Real* const* f, std::ptrdiff_t i) {
        const Real *u = f[0] + i, *v = gradient ? u : f[1] + i, *w = gradient || D < 3 ? u : f[2] + i;
        for (const Rows& r : stencil.rows[int(Beside::none)][S]) add_odd<S>(r, load(u));
        for (const Rows& r : stencil.rows[int(Beside::y)][S]) add_pair<S, 0>(r, u, v, r.y);
        if constexpr (D == 3) {
            for (const Rows& r : stencil.rows[int(Beside::z)][S]) add_pair<S, 1>(r, u, w, r.z);
            for (const Rows& r : stencil.rows[int(Beside::both)][S]) add_four<S>(r, u, v, w);
        }
    }

    template <int S, int axis>
    [[gnu::always_inline]] void add_pair(const Rows& r, const Real* u, const Real* along, std::ptrdiff_t at) {
        const Lane a = load(u + at), b = load(u - at);
        add_odd<S>(r, a + b);
        add_even<S, axis>(r, gradient ? a - b : load(along + at) - load(along - at));
    }

    template <int S>
    [[gnu::always_inline]] void add_four(const Rows& r, const Real* u, const Real* v, const Real* w) {
        const std::ptrdiff_t y = r.y, z = r.z;
        const Lane a = load(u + z + y), b = load(u + z - y), c = load(u - z + y), d = load(u - z - y), near = c + d, far = a + b;
        add_odd<S>(r, far + near);
        if constexpr (gradient) {
            add_even<S, 0>(r, (a - b) + (c - d));
            add_even<S, 1>(r, far - near);
        } else {
            add_even<S, 0>(r, (load(v + z + y) - load(v + z - y)) + (load(v - z + y) - load(v - z - y)));
            add_even<S, 1>(r, (load(w + z + y) + load(w + z - y)) - (load(w - z + y) + load(w - z - y)));
        }
    }

    template <int S>
    [[gnu::always_inline]] void add_odd(const Rows& r, Lane sum) {
#pragma GCC unroll 4
        for (int s = 0; s < S; ++s) odd[s] += r.odd[s] * sum;
    }
    template <int S, int axis>
    [[gnu::always_inline]] void add_even(const Rows& r, Lane difference) {
#pragma GCC unroll 5
        for (int s = 0; s <= S; ++s) even[gradient ? axis : 0][s] += r.even[axis][s] * difference;
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

template <class Real, int D, int R, bool gradient>
class SlidingRow {
public:
    using Lane = LaneOf<Real>;
    static constexpr int lanes = lanes_of<Real>;
    static constexpr int outputs = gradient ? D : 1;
    using Window = Columns<Real, D, R, gradient>;

    /// From afar, what the next row is the first to read and to write is fetched meanwhile: no prefetcher follows so many rows.
    static void apply(const SlidingStencil<Real>& stencil, const Real* const* f, std::ptrdiff_t offset, long n, const Finish<Real>& finish, Real* const* out) {
        Window here(stencil, f, offset);
        Sums sum = begun(Window(stencil, f, offset - lanes), here, along());
        for (long i = 0; i < n; i += lanes) {
            if (n - i + R <= lanes) {    // the last of a row reach no further than their own vector
                add_next(sum, here, here, along());
                return finish_part<Real, outputs>(sum.of, finish, out, offset + i, n - i);
            }
            const Window ahead(stencil, f, offset + i + lanes);
            if (stencil.far) fetch_next(stencil, f, offset + i, out);
            add_next(sum, here, ahead, along());
            if (n - i >= lanes)
                finish_block<Real, outputs, 1>(sum.of, finish, out, offset + i);
            else
                finish_part<Real, outputs>(sum.of, finish, out, offset + i, n - i);
            sum = begun(here, ahead, along());
            here = ahead;
        }
    }

private:
    struct Sums {
        Lane of[outputs][1];
    };
    static constexpr auto along() { return std::make_integer_sequence<int, R>(); }

    [[gnu::always_inline]] static void fetch_next(const SlidingStencil<Real>& stencil, const Real* const* f, std::ptrdiff_t i, Real* const* out) {
        for (int c = 0; c < stencil.components; ++c) __builtin_prefetch(f[c] + i + stencil.next);
#pragma GCC unroll 3
        for (int o = 0; o < outputs; ++o) __builtin_prefetch(out[o] + i + stencil.next_own, 1);
    }

    /// What places get from themselves and from those behind them: B_0(i) + sum_s B_s(i - s) and -A_s(i - s).
    template <int... S>
    [[gnu::always_inline]] static Sums begun(const Window& behind, const Window& here, std::integer_sequence<int, S...>) {
        Sums sum;
#pragma GCC unroll 3
        for (int o = 0; o < outputs; ++o) sum.of[o][0] = gradient && o == 0 ? Lane{} : here.even[gradient ? o - 1 : 0][0];
        ((sum.of[0][0] -= shifted<lanes - 1 - S>(behind.odd[S], here.odd[S])), ...);
#pragma GCC unroll 2
        for (int e = 0; e < Window::sets; ++e) ((sum.of[gradient ? 1 + e : 0][0] += shifted<lanes - 1 - S>(behind.even[e][S + 1], here.even[e][S + 1])), ...);
        return sum;
    }
    /// And from those ahead: sum_s B_s(i + s) and A_s(i + s).
    template <int... S>
    [[gnu::always_inline]] static void add_next(Sums& sum, const Window& here, const Window& ahead, std::integer_sequence<int, S...>) {
        ((sum.of[0][0] += shifted<1 + S>(here.odd[S], ahead.odd[S])), ...);
#pragma GCC unroll 2
        for (int e = 0; e < Window::sets; ++e) ((sum.of[gradient ? 1 + e : 0][0] += shifted<1 + S>(here.even[e][S + 1], ahead.even[e][S + 1])), ...);
    }
};

/// A derivative along a set of one dimension, sum_s w_s (f(i + s) - f(i - s)), s = 1 ... R, every value loaded once.
template <class Real, int R>
void slide_along(const Real* weight, const Real* f, std::ptrdiff_t offset, long n, const Finish<Real>& finish, Real* const* out) {
    constexpr int lanes = lanes_of<Real>;
    static_assert(R < lanes);
    using Lane = LaneOf<Real>;
    Lane behind = load(f + offset - lanes), here = load(f + offset);
    for (long i = 0; i < n; i += lanes) {
        const Lane ahead = load(f + offset + i + lanes);
        Lane sum[1][1] = {};
        [&]<int... S>(std::integer_sequence<int, S...>) {
            ((sum[0][0] += weight[S] * (shifted<S + 1>(here, ahead) - shifted<lanes - 1 - S>(behind, here))), ...);
        }(std::make_integer_sequence<int, R>());
        if (n - i >= lanes)
            finish_block<Real, 1, 1>(sum, finish, out, offset + i);
        else
            finish_part<Real, 1>(sum, finish, out, offset + i, n - i);
        behind = here;
        here = ahead;
    }
}

}    // namespace sphonic
