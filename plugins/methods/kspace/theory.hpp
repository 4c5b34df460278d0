#pragma once
#include <algorithm>
#include <cmath>

#include "operators.hpp"

namespace kspace {

/// rate = -K div 1/rho0 grad p; W is room for work, p's own modes are lost.
inline void second_rate(Operators& operators, const Grid& grid, const Media& media, Modes& P, Modes* W, Field& rate) {
    for (int a = 0; a < grid.dimension; ++a) {
        operators.slope(a, P, rate);
        for (std::size_t i = 0; i < rate.size(); ++i) rate[i] /= media.density_of(a, i);
        operators.analyse(a, rate, W[a]);
    }
    operators.divergence(W, rate);
    for (std::size_t i = 0; i < rate.size(); ++i) rate[i] *= -media.bulk_of(i);
}

/// The largest eigenvalue of that operator, by power iteration in the energy's norm, where it is symmetric: a little too small. Asked
/// again, after the operators have changed a little, it goes on with the field that it had.
class LargestEigenvalue {
public:
    LargestEigenvalue(Operators& operators, const Grid& grid, const Media& media)
        : operators_(operators), grid_(grid), media_(media), p_(std::size_t(grid.size)), rate_(p_.size()), P_(operators.spectrum.modes()), W_{P_, P_, P_} {
        for (std::size_t i = 0; i < rate_.size(); ++i) rate_[i] = std::sin(1e4 * std::sin(double(i + 1)));
    }

    double operator()() {
        const int iterations = asked_++ ? 20 : 60;
        double largest = 0;
        for (int it = 0; it < iterations; ++it) largest = std::max(largest, iterate());
        return largest;
    }

private:
    Operators& operators_;
    const Grid& grid_;
    const Media& media_;
    Field p_, rate_;
    Modes P_, W_[3];
    int asked_ = 0;

    double iterate() {
        double squares = 0, product = 0;
        for (std::size_t i = 0; i < p_.size(); ++i) squares += rate_[i] * rate_[i] / media_.bulk_of(i);
        for (std::size_t i = 0; i < p_.size(); ++i) p_[i] = rate_[i] / std::sqrt(squares);
        operators_.spectrum.forward(p_, P_);
        second_rate(operators_, grid_, media_, P_, W_, rate_);
        for (std::size_t i = 0; i < p_.size(); ++i) product += p_[i] * rate_[i] / media_.bulk_of(i);
        return product;
    }
};

/// The largest stable step [s] not above `dt`: dt^2 lambda <= 4 for the largest eigenvalue lambda, which the corrected operators make no
/// larger than 4 max K / (min rho0 c^2 dt^2), c the fastest medium's. Lambda depends on dt, so shorter
/// steps are tried until one will do.
inline double stable_step(Operators& operators, const Grid& grid, const Media& media, double dt) {
    if (media.uniform()) return dt;
    const double c = media.fastest().c0;
    double lightest = 0;
    for (int a = 0; a < grid.dimension; ++a) lightest = std::max(lightest, *std::max_element(media.lightness[a].begin(), media.lightness[a].end()));
    if (*std::max_element(media.bulk.begin(), media.bulk.end()) * lightest <= c * c * (1 + 1e-12)) return dt;
    constexpr double margin = 1.03, shorter = 0.98;
    LargestEigenvalue largest(operators, grid, media);
    for (;; dt *= shorter) {
        operators.spectrum.time(c, dt);
        if (!(margin * dt * dt * largest() > 4)) return dt;
    }
}

/// sin(omega dt/2) = c0/c sin(c k dt/2), c the fastest medium's; the gain is 1.
inline abi::ToneResponse tone_response(int dimension, double c, double c0, double omega, double dt) {
    const double k = 2 / (c * dt) * std::asin(std::min(1.0, c / c0 * std::sin(0.5 * omega * dt)));
    return {k, std::pow(k * c0 / omega, 0.5 * (dimension - 1))};
}

/// The continuous wave: exact at any step.
inline abi::CarriedWave carried(const abi::Medium& m, int dimension, const double* k) {
    abi::CarriedWave wave;
    double squares = 0;
    for (int a = 0; a < dimension; ++a) squares += k[a] * k[a];
    wave.omega = m.c0 * std::sqrt(squares);
    for (int a = 0; a < dimension && squares > 0; ++a) wave.along[a] = k[a] / std::sqrt(squares);
    return wave;
}

/// u = (1 - S)^(1/2) u, S = -(dt/2)^2 1/rho0 grad K div, by its power series. S is sin^2(omega dt/2) of each wave.
inline void centre(Operators& operators, const Grid& grid, const Media& media, double dt, Field* u) {
    constexpr int terms = 40;
    const std::size_t n = std::size_t(grid.size);
    Field sum[3], p(n);
    Modes P(operators.spectrum.modes()), W[3] = {P, P, P};
    for (int a = 0; a < grid.dimension; ++a) sum[a] = u[a];
    double coefficient = 1;
    for (int k = 1; k <= terms; ++k) {
        coefficient *= (k - 1.5) / k;
        for (int a = 0; a < grid.dimension; ++a) operators.analyse(a, u[a], W[a]);
        operators.divergence(W, p);
        for (std::size_t i = 0; i < n; ++i) p[i] *= -dt / 2 * media.bulk_of(i);
        operators.spectrum.forward(p, P);
        for (int a = 0; a < grid.dimension; ++a) {
            operators.slope(a, P, u[a]);
            for (std::size_t i = 0; i < n; ++i) sum[a][i] += coefficient * (u[a][i] *= dt / 2 / media.density_of(a, i));
        }
    }
    for (int a = 0; a < grid.dimension; ++a) u[a] = sum[a];
}

}    // namespace kspace
