#include "wall_footprint.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace sphonic {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int samples = 1000, sharpest = 16;
constexpr int at_20_points = samples / 10;    ///< the node of that many points per wavelength

double node(int i) { return pi * (i + 0.5) / samples; }

/// F(q)/F'(0) along an axis, at the nodes.
std::vector<double> operator_along(const Case& scene, int axis) {
    double along[3] = {0, 0, 0};
    along[axis] = 1;
    const LatticeOperator set(scene);
    const double scale = scene.box.dx / set.long_wave_speed(along);
    std::vector<double> F;
    for (int i = 0; i < samples; ++i) F.push_back(scale * set.dispersion(node(i) / scene.box.dx, along));
    return F;
}

/// The shortest wave of the frequency of 20 points per wavelength.
double short_wave(const std::vector<double>& F) {
    int i = samples - 1;
    while (i > at_20_points && F[std::size_t(i)] < F[at_20_points]) --i;
    return node(i);
}

/// S by its parameters.
struct Shape {
    int n = 1;
    double a = 0, b = 0;

    double operator()(double q) const {
        const double s = std::pow(std::sin(q / 2), 2);
        return std::pow(1 - s, n) * (1 + a * s + b * s * s);
    }
    /// Chooses b for near fields without mass: the larger root of a quadratic equation, if there is one.
    bool balance(const std::vector<double>& F) {
        double constant = -1 / pi, linear = 0, square = 0;
        for (int i = 0; i < samples; ++i) {
            const double q = node(i), f2 = F[std::size_t(i)] * F[std::size_t(i)], plain = Shape{n, a, 0}(q), change = Shape{n, a, 1}(q) - plain;
            constant += pi / samples * (plain * plain / f2 - 1 / (q * q));
            linear += pi / samples * 2 * plain * change / f2;
            square += pi / samples * change * change / f2;
        }
        const double discriminant = linear * linear - 4 * square * constant;
        if (discriminant < 0) return false;
        b = (-linear + std::sqrt(discriminant)) / (2 * square);
        return true;
    }
};

}    // namespace

std::vector<double> wall_footprint(const Case& scene, int axis, double dt) {
    const std::vector<double> F = operator_along(scene, axis);
    const double other = short_wave(F), q = node(at_20_points), courant = scene.medium.c0 * dt / scene.box.dx;
    const double bend = (1 - F[at_20_points] / q) / (q * q);    // F = q - bend q^3
    Shape S;
    const auto fits = [&] {
        S.a = S.n - 6 * bend + courant * courant / 4;
        return S.balance(F) && std::abs(S(other)) < 0.03;
    };
    while (!fits() && S.n < sharpest) ++S.n;
    std::vector<double> weight;
    for (int m = 0; m <= S.n + 2; ++m) {
        double sum = 0;
        for (int i = 0; i < samples; ++i) sum += S(node(i)) * std::cos(node(i) * m) / samples;
        weight.push_back(m == 0 ? sum : 2 * sum);
    }
    return weight;
}

}    // namespace sphonic
