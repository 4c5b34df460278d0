#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <sphonic/plugin/form.hpp>

namespace sphonic::band {

/// Means over the waves exp(i k . r) of a band |k| <= k_end, uniform in wave-number space, as functions of the distance r in spacings:
///   value  K(r) = < cos k . r >,    slope  S(r) = < F(|k|) k.r/(|k| r^2) sin k . r >,    F = 2 sin(C |k|/2)/C, or |k| at C = 0.
/// Over all directions cos and sin become cos and sin in 1-D, the Bessel functions J0 and J1 in 2-D, the spherical j0 and j1 in 3-D,
/// here called a and b; over the magnitudes the mean is by Gauss's quadrature. Tabulated, with cubic interpolation of values and derivatives.
class BandAverages {
public:
    BandAverages(int dimension, double k_end, double courant, double farthest) {
        for (int i = 0; i <= int(farthest / step) + 1; ++i) table_.push_back(node(dimension, k_end, courant, i * step));
    }
    double value(double r) const { return interpolate<0>(r); }
    double slope(double r) const { return interpolate<2>(r); }

private:
    static constexpr double step = 0.02;    ///< errors of 1e-9
    using Node = std::array<double, 4>;     ///< K, K', S, S'
    std::vector<Node> table_;

    template <std::size_t f>
    double interpolate(double r) const {
        const auto i = std::min(std::size_t(r / step), table_.size() - 2);
        const double t = r / step - double(i), s = 1 - t;
        const Node &at = table_[i], &next = table_[i + 1];
        return s * s * ((1 + 2 * t) * at[f] + t * step * at[f + 1]) + t * t * ((1 + 2 * s) * next[f] - s * step * next[f + 1]);
    }

    static Node node(int dimension, double k_end, double courant, double r) {
        Node sum{};
        double total = 0;
        for (const auto& [point, weight] : gauss()) {
            const double k = k_end * point, share = weight * std::pow(point, dimension - 1), x = k * r;
            const double F = courant > 0 ? 2 / courant * std::sin(0.5 * courant * k) : k;
            const auto [a, b_over_x, slope_of_that] = directions(dimension, x);
            total += share;
            sum[0] += share * a;
            sum[1] -= share * k * b_over_x * x;
            sum[2] += share * F * k * b_over_x;
            sum[3] += share * F * k * k * slope_of_that;
        }
        for (double& value : sum) value /= total;
        return sum;
    }

    /// a(x), b(x)/x and the latter's derivative, from b' = a - (d - 1) b/x; by their series near 0.
    static std::array<double, 3> directions(int d, double x) {
        if (x < 0.1) {    // a = 1 - x^2/(2d) + x^4/(8 d (d + 2)), b = -a'
            const double x2 = x * x, e = d * (d + 2), g = e * (d + 4);
            return {1 - x2 / (2 * d) + x2 * x2 / (8 * e), 1. / d - x2 / (2 * e) + x2 * x2 / (8 * g), -x / e + x * x2 / (2 * g)};
        }
        const double a = d == 1 ? std::cos(x) : d == 2 ? std::cyl_bessel_j(0., x) : std::sin(x) / x;
        const double b = d == 1 ? std::sin(x) : d == 2 ? std::cyl_bessel_j(1., x) : (std::sin(x) / x - std::cos(x)) / x;
        return {a, b / x, (a - d * b / x) / x};
    }

    /// Points and weights of Gauss's rule on [0, 1], by Newton's method on Legendre's polynomial.
    static std::vector<std::array<double, 2>> gauss() {
        constexpr int n = 12;
        std::vector<std::array<double, 2>> rule;
        for (int i = 0; i < n; ++i) {
            double x = std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 1;
            for (int round = 0; round < 8; ++round) {
                double before = 1, at = x;
                for (int m = 2; m <= n; ++m) {
                    const double next = ((2 * m - 1) * x * at - (m - 1) * before) / m;
                    before = at;
                    at = next;
                }
                slope = n * (x * at - before) / (x * x - 1);
                x -= at / slope;
            }
            rule.push_back({0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope)});
        }
        return rule;
    }
};

}    // namespace sphonic::band
