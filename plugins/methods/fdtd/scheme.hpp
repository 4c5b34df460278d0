#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "../staggered/media.hpp"

namespace fdtd {

using staggered::Grid;
using staggered::Media;

/// dx times the derivative at i + 1/2 of f, known at whole i: f[i+1] - f[i], or 9/8 (f[i+1] - f[i]) - 1/24 (f[i+2] - f[i-1]).
inline constexpr double inner_weight = 9. / 8, outer_weight = 1. / 24;
template <int order>
double ahead(const double* f, long i, long step) {
    if constexpr (order == 2)
        return f[i + step] - f[i];
    else
        return inner_weight * (f[i + step] - f[i]) - outer_weight * (f[i + 2 * step] - f[i - step]);
}

/// The two halves of a step of h on a grid of d axes: u -= h/rho0 grad p, p -= h K div u. The ghosts hold what lies beyond the faces.
/// After each row, ended(row) may set those at its ends.
template <int d, int order, bool several>
class Halves {
public:
    template <class Ended>
    static void kick(const Grid& g, const Media& media, const double* p, double* const* u, double h, Ended ended) {
        kick_lower_ends(g, media, p, u, h);
        g.for_rows([&](long row) {
            kick_row(g, media, p, u, row, h);
            ended(row);
        });
    }
    template <class Ended>
    static void drift(const Grid& g, const Media& media, double* p, const double* const* u, double h, Ended ended) {
        g.for_rows([&](long row) {
            drift_row(g, media, p, u, row, h);
            ended(row);
        });
    }
    /// Both in one pass: at order 2 no row needs u of the next.
    template <class Ended>
    static void both(const Grid& g, const Media& media, double* p, double* const* u, double h, Ended ended) {
        static_assert(order == 2);
        kick_lower_ends(g, media, p, u, h);
        g.for_rows([&](long row) {
            kick_row(g, media, p, u, row, h);
            drift_row(g, media, p, u, row, h);
            ended(row);
        });
    }

private:
    static double kick_factor(const Grid& g, const Media& media, double h) { return h / g.dx * (several ? 1 : 1 / media.of(0).rho0); }

    static void kick_row(const Grid& g, const Media& media, const double* p, double* const* u, long row, double h) {
        const double factor = kick_factor(g, media, h);
        const long s1 = g.stride[1], s2 = g.stride[2], n = g.n[0];
        const double* __restrict f = p + row;
        double *__restrict x = u[0] + row, *__restrict y = d > 1 ? u[1] + row : nullptr, *__restrict z = d > 2 ? u[2] + row : nullptr;
        const auto light = [&](int a) { return several && a < d ? media.lightness[a].data() + row : nullptr; };
        const double *__restrict lx = light(0), *__restrict ly = light(1), *__restrict lz = light(2);
#pragma omp simd
        for (long i = 0; i < n; ++i) {
            x[i] -= (several ? factor * lx[i] : factor) * ahead<order>(f, i, 1);
            if constexpr (d > 1) y[i] -= (several ? factor * ly[i] : factor) * ahead<order>(f, i, s1);
            if constexpr (d > 2) z[i] -= (several ? factor * lz[i] : factor) * ahead<order>(f, i, s2);
        }
        along<0>(g, media, p, u, row - 1, 1, h);
    }
    /// u across the lower faces of all axes but x.
    static void kick_lower_ends(const Grid& g, const Media& media, const double* p, double* const* u, double h) {
        if constexpr (d > 1)
            for (long k = 0; k < g.n[2]; ++k) along<1>(g, media, p, u, g.origin - g.stride[1] + k * g.stride[2], g.n[0], h);
        if constexpr (d > 2)
            for (long j = 0; j < g.n[1]; ++j) along<2>(g, media, p, u, g.origin - g.stride[2] + j * g.stride[1], g.n[0], h);
    }
    /// u along one axis at n points.
    template <int axis>
    static void along(const Grid& g, const Media& media, const double* p, double* const* u, long at, long n, double h) {
        const double factor = kick_factor(g, media, h);
        const double *__restrict f = p + at, *__restrict l = several ? media.lightness[axis].data() + at : nullptr;
        double* __restrict v = u[axis] + at;
        const long step = g.stride[axis];
        for (long i = 0; i < n; ++i) v[i] -= (several ? factor * l[i] : factor) * ahead<order>(f, i, step);
    }
    static void drift_row(const Grid& g, const Media& media, double* p, const double* const* u, long row, double h) {
        const double factor = h / g.dx * (several ? 1 : Media::modulus(media.of(0)));
        const long s1 = g.stride[1], s2 = g.stride[2], n = g.n[0];
        double* __restrict f = p + row;
        const double *__restrict K = several ? media.bulk.data() + row : nullptr, *__restrict x = u[0] + row - 1,
                     *__restrict y = d > 1 ? u[1] + row - s1 : nullptr, *__restrict z = d > 2 ? u[2] + row - s2 : nullptr;
#pragma omp simd
        for (long i = 0; i < n; ++i) {
            double sum = ahead<order>(x, i, 1);
            if constexpr (d > 1) sum += ahead<order>(y, i, s1);
            if constexpr (d > 2) sum += ahead<order>(z, i, s2);
            f[i] -= (several ? factor * K[i] : factor) * sum;
        }
    }
};

}    // namespace fdtd
