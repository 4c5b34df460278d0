#include "kernel_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <sphonic/error.hpp>
#include <sphonic/stability.hpp>

#include "kernel_case.hpp"
#include "stencil.hpp"

namespace sphonic {
namespace {

constexpr double pi = std::numbers::pi, farthest_ppw = 1000, wavelengths = 10, infinite = std::numeric_limits<double>::infinity();

/// Along an axis and along the diagonal of the square or cube.
std::vector<std::array<double, 3>> directions(int d) {
    std::vector<std::array<double, 3>> all{{1, 0, 0}};
    const double s = 1 / std::sqrt(double(d));
    if (d > 1) all.push_back({s, s, d > 2 ? s : 0});
    return all;
}

/// Of larger magnitude.
double larger(double a, double b) { return std::abs(a) > std::abs(b) ? a : b; }

double speed_error(const LatticeOperator& plain, int dimension) {
    double worst = 0;
    for (const auto& along : directions(dimension)) worst = larger(worst, plain.long_wave_speed(along.data()) - 1);
    return worst;
}

/// Of the first maximum of the frequency along an axis, in steps of 1 % of the zone.
double cutoff_ppw(const LatticeOperator& set) {
    const double along[3] = {1, 0, 0};
    double last = 0, k = 0;
    for (int i = 1; i <= 100; ++i) {
        const double next = set.dispersion(pi * i / 100, along);
        if (next < last) break;
        last = next, k = pi * i / 100;
    }
    return 2 * pi / k;
}

/// |exp(i phi) - 1| of the phase error phi after ten wavelengths, the larger of the directions.
double lost(const LatticeOperator& set, int dimension, double per_wavelength) {
    double worst = 0;
    const double k = 2 * pi / per_wavelength;
    for (const auto& along : directions(dimension)) {
        const double phase = 2 * pi * wavelengths * (set.dispersion(k, along.data()) / k - 1);
        worst = std::max(worst, std::abs(phase) > pi ? 2 : 2 * std::abs(std::sin(phase / 2)));
    }
    return worst;
}

/// Where a wave of any more points per wavelength loses less than the target: from long waves down, then by bisection.
std::optional<double> needed(const LatticeOperator& set, int dimension, double target) {
    constexpr double factor = 0.95;
    if (lost(set, dimension, farthest_ppw) > target) return {};
    double good = farthest_ppw;
    while (good > 2 && lost(set, dimension, good * factor) <= target) good *= factor;
    if (good <= 2) return 2;
    double bad = good * factor;
    while (good - bad > 1e-4 * good) {
        const double middle = 0.5 * (good + bad);
        (lost(set, dimension, middle) <= target ? good : bad) = middle;
    }
    return good;
}

}    // namespace

std::optional<double> KernelRow::work() const {
    const auto limit = courant_dx.find("leapfrog");
    if (!ppw_1_percent || limit == courant_dx.end()) return {};
    const double corrected = limit->second * (1 + speed_error);    // weights are smaller by what the speed was too large
    return neighbours * std::pow(*ppw_1_percent, dimension + 1) / corrected;
}

KernelRows::KernelRows(Registry& registry) : registry_(registry) {
    for (const std::string& name : registry.names("integrator")) {
        const double limit = oscillator_limit(kernel_case(registry, "cubic_spline", 1, 1, Pairing::plain, name));
        if (limit > 0) oscillation_[name] = limit;
    }
}

std::optional<KernelRow> KernelRows::row(const std::string& kernel, int dimension, double h_over_dx, double least_work) const {
    const Case plain = kernel_case(registry_, kernel, dimension, h_over_dx, Pairing::plain);
    KernelRow row{.dimension = dimension, .h_over_dx = h_over_dx};
    row.neighbours = int(lattice_neighbours(plain.box, plain.kernels.front()).size());
    if (row.neighbours < 2 * dimension || row.neighbours > most_neighbours) return {};
    const LatticeOperator by_plain(plain);
    row.speed_error = speed_error(by_plain, dimension);
    if (row.speed_error < -0.95) return {};    // next to no slope where the neighbours are
    const Case corrected = kernel_case(registry_, kernel, dimension, h_over_dx, Pairing::corrected);
    const LatticeOperator set(corrected);
    row.ppw_1_percent = needed(set, dimension, 0.01);
    const double longest_step = std::max(2.0, 1.2 * plain.kernels.front().kernel->support() * h_over_dx);    // more than leapfrog's by any kernel
    if (row.ppw_1_percent && row.neighbours * std::pow(*row.ppw_1_percent, dimension + 1) / longest_step > least_work) return {};
    row.ppw_01_percent = needed(set, dimension, 0.001);
    row.cutoff_ppw = cutoff_ppw(set);
    const double fastest = step_limit(plain).frequency;
    for (const auto& [name, limit] : oscillation_) row.courant_dx[name] = limit / fastest;
    return row;
}

std::optional<KernelRow> KernelRows::best(const std::string& kernel, int dimension) const {
    std::optional<KernelRow> best;
    for (int tenth = 5; tenth <= 40; ++tenth) {
        const auto one = row(kernel, dimension, 0.1 * tenth, best ? *best->work() : infinite);
        if (one && one->work() && (!best || *one->work() < *best->work())) best = one;
    }
    return best;
}

KernelDispersion KernelRows::dispersion(const std::string& kernel, int dimension, double h_over_dx) const {
    const Case c = kernel_case(registry_, kernel, dimension, h_over_dx, Pairing::corrected);
    const LatticeOperator set(c);
    const double along[3] = {1, 0, 0};
    KernelDispersion curve{.h_over_dx = h_over_dx, .per_wavelength = {}, .speed = {}};
    for (double n = 2; n < 40; n *= 1.02) {
        curve.per_wavelength.push_back(n);
        curve.speed.push_back(set.dispersion(2 * pi / n, along) * n / (2 * pi));
    }
    return curve;
}

}    // namespace sphonic
