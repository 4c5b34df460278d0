#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "scheme.hpp"

namespace fdtd {

/// A bound of the largest eigenvalue of -dx^2 K div 1/rho0 grad. With all signs made positive, |A|, none is larger than the largest
/// ratio (|A| w)_i / w_i for any w > 0 (Collatz and Wielandt); each round makes a better w. In one medium the first is exact:
/// 4 d c0^2 at order 2, (7/3)^2 d c0^2 at order 4.
inline double largest_eigenvalue(const Grid& g, const Media& media, int order) {
    const double near = order == 2 ? 1 : inner_weight, far = order == 2 ? 0 : outer_weight;
    if (media.uniform()) return 4 * g.dimension * (near + far) * (near + far) * media.of(0).c0 * media.of(0).c0;
    constexpr int rounds = 40;
    std::vector<double> w(std::size_t(g.size), 1.0), next(w.size()), slope;
    double bound = 0;
    for (int round = 0; round < rounds; ++round) {
        std::fill(next.begin(), next.end(), 0.0);
        for (int a = 0; a < g.dimension; ++a) {
            const long n = g.n[a], most = g.ghosts - 1;
            g.for_lines(a, [&](long line) {
                const auto at = [&](long i) { return std::size_t(line + std::clamp(g.image(a, i), 0L, n - 1) * g.stride[a]); };
                slope.resize(std::size_t(n + 1 + 2 * most));
                for (long i = -1 - most; i < n + most; ++i)
                    slope[std::size_t(i + 1 + most)] = media.lightness[a][std::size_t(line + i * g.stride[a])] *
                                                       (near * (w[at(i)] + w[at(i + 1)]) + (far > 0 ? far * (w[at(i - 1)] + w[at(i + 2)]) : 0));
                for (long i = 0; i < n; ++i) {
                    const double* s = slope.data() + i + 1 + most;
                    next[at(i)] += media.bulk[at(i)] * (near * (s[-1] + s[0]) + (far > 0 ? far * (s[-2] + s[1]) : 0));
                }
            });
        }
        double ratio = 0;
        g.for_rows([&](long row) {
            for (long i = row; i < row + g.n[0]; ++i) ratio = std::max(ratio, next[std::size_t(i)] / w[std::size_t(i)]);
        });
        bound = round == 0 ? ratio : std::min(bound, ratio);
        for (std::size_t i = 0; i < w.size(); ++i) w[i] = 0.5 * (w[i] + next[i] / ratio);
    }
    return bound;
}

/// [s]: (dt/dx)^2 lambda <= 4.
inline double stable_step(const Grid& g, const Media& media, int order) { return 2 * g.dx / std::sqrt(largest_eigenvalue(g, media, order)); }

/// sin(omega dt/2) = (c0 dt/dx) sqrt(n) G(theta), theta = k dx / (2 sqrt n), along a diagonal of n axes; mean over n, the axis included.
/// A tone added half-way through a step has the gain c0 over the semi-discrete group velocity, 1/G'(theta).
inline abi::ToneResponse tone_response(const Grid& g, const abi::Medium& m, int order, double omega, double dt) {
    const double near = order == 2 ? 1 : inner_weight, far = order == 2 ? 0 : outer_weight;
    abi::ToneResponse mean{0, 0};
    for (int n = 1; n <= g.dimension; ++n) {
        const double root = std::sqrt(double(n)), wanted = std::sin(0.5 * omega * dt) * g.dx / (m.c0 * dt * root);
        double low = 0, high = std::acos(-1.0) / 2;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (near * std::sin(middle) - far * std::sin(3 * middle) < wanted ? low : high) = middle;
        }
        const double k = 2 * root * low / g.dx, slope = near * std::cos(low) - 3 * far * std::cos(3 * low);
        mean.wave_number += k / g.dimension;
        mean.gain += std::pow(k * m.c0 / omega, 0.5 * (g.dimension - 1)) / slope / g.dimension;
    }
    return mean;
}

/// sin(omega dt/2) = c0 dt/2 |G|, along G: G_a = 2/dx (near sin(theta_a) - far sin(3 theta_a)), theta_a = k_a dx/2.
inline abi::CarriedWave carried(const abi::Medium& m, int dimension, double dx, int order, double dt, const double* k) {
    const double near = order == 2 ? 1 : inner_weight, far = order == 2 ? 0 : outer_weight;
    abi::CarriedWave wave;
    double squares = 0;
    for (int a = 0; a < dimension; ++a) {
        const double theta = 0.5 * k[a] * dx;
        wave.along[a] = 2 / dx * (near * std::sin(theta) - far * std::sin(3 * theta));
        squares += wave.along[a] * wave.along[a];
    }
    const double length = std::sqrt(squares);
    wave.omega = 2 / dt * std::asin(std::min(1.0, 0.5 * m.c0 * dt * length));
    for (int a = 0; a < dimension && length > 0; ++a) wave.along[a] /= length;
    return wave;
}

}    // namespace fdtd
