#include "step_map.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <sphonic/stability.hpp>

#include "linear_algebra.hpp"

namespace sphonic {
namespace {

constexpr double small = 1e-7;         ///< of the states that a step is tried on, in units of the medium
constexpr double grows = 1e-4;         ///< of |xi| - 1: what counts as growth, where all roots are found
constexpr double clearly = 1e-3;       ///< the same, where the largest shows in repetition
constexpr std::size_t most = 640;      ///< values of a map that is found column by column
constexpr int repetitions = 1500;      ///< of a larger one
constexpr int at_once = 10;            ///< of them, whose growth is far from overflow

}    // namespace

StepMap::StepMap(const Case& scene) : scene_(scene), system_(scene), viscous_(is_viscous(scene)) {}

void StepMap::step() {
    scene_.integrator->step(system_, {index_, double(index_) * dt_, dt_});
    ++index_;
    system_.close_step(double(index_) * dt_, dt_);
}

/// Two steps from noise name all arrays and show how large their values are; then two from rest, to which states are differences.
void StepMap::begin(double dt) {
    dt_ = dt;
    std::mt19937_64 bits(1);
    std::vector<double> x(std::size_t(system_.values()));
    for (const double scale : {1.0, 0.0}) {
        for (double& value : x) value = scale * (double(bits() >> 11) * 0x1p-52 - 1);
        index_ = 0;
        system_.begin_with(x.data(), small, dt);
        scene_.integrator->begin(system_, dt);
        system_.forget_walls();
        step();
        step();
        all_ = system_.everything();
        rest_.clear();
        for (const auto& values : all_) rest_.insert(rest_.end(), values.begin(), values.end());
        if (scale > 0) unit_ = rest_;
    }
    for (std::size_t i = 0; i < unit_.size(); ++i) unit_[i] -= rest_[i];
    for (std::size_t at = 0, a = 0; a < all_.size(); at += all_[a++].size()) {
        double squares = 0;
        for (std::size_t i = at; i < at + all_[a].size(); ++i) squares += unit_[i] * unit_[i];
        const double typical = std::sqrt(squares / double(all_[a].size()));
        std::fill_n(unit_.begin() + std::ptrdiff_t(at), all_[a].size(), typical > 0 ? typical : 1.0);
    }
}

/// Steps from small x; of one where viscosity acts on approaching particles only, the odd part. Time goes on, as walls ask for the time
/// that has passed since the step before.
void StepMap::apply(const double* x, double* y, int steps) {
    const std::vector<double> both{0.5, -0.5}, one{1};
    std::fill_n(y, rest_.size(), 0.0);
    for (const double share : viscous_ ? both : one) {
        const double sign = share > 0 ? 1 : -1;
        std::size_t i = 0;
        for (const auto& values : all_)
            for (double& value : values) value = rest_[i] + sign * unit_[i] * x[i], ++i;
        for (int k = 0; k < steps; ++k) step();
        all_ = system_.everything();
        i = 0;
        for (const auto& values : all_)
            for (const double value : values) y[i] += share * (value - rest_[i]) / unit_[i], ++i;
    }
}

double StepMap::largest_root(double dt) {
    begin(dt);
    return rest_.size() <= most ? root_of_all() : root_by_repetition();
}

double StepMap::root_of_all() {
    const std::size_t n = rest_.size();
    std::vector<double> matrix(n * n), x(n, 0.0), y(n);
    for (std::size_t column = 0; column < n; ++column) {
        x[column] = 1;
        apply(x.data(), y.data(), 1);
        x[column] = 0;
        for (std::size_t row = 0; row < n; ++row) matrix[row * n + column] = y[row];
    }
    double largest = 0;
    for (const auto& xi : eigenvalues(int(n), matrix.data())) largest = std::max(largest, std::abs(xi));
    return largest;
}

/// The mean factor in size over the second half: of powers of n, as of motions that drift, it is 1 + 1/n.
double StepMap::root_by_repetition() {
    std::vector<double> x(rest_.size()), y(rest_.size());
    std::mt19937_64 bits(1);
    for (double& value : x) value = double(bits() >> 11) * 0x1p-52 - 1;
    const int steps = viscous_ ? 1 : at_once;
    double log_growth = 0;
    for (int k = 0; k < repetitions; k += steps) {
        apply(x.data(), y.data(), steps);
        const double size = std::sqrt(std::inner_product(y.begin(), y.end(), y.begin(), 0.0) / std::inner_product(x.begin(), x.end(), x.begin(), 0.0));
        if (2 * k >= repetitions) log_growth += std::log(size);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = y[i] / size;
    }
    return std::exp(log_growth / (repetitions - repetitions / 2));
}

double StepMap::last_stable(double omega) {
    const auto stable = [&](double dt) { return largest_root(dt) <= 1 + (rest_.size() <= most ? grows : clearly); };
    double low = 0.2 / omega, high = low;
    if (!stable(low)) return 0;
    while (high < 20 / omega && stable(high *= 1.1)) low = high;
    while (high - low > 1e-3 * low) {
        const double middle = 0.5 * (low + high);
        (stable(middle) ? low : high) = middle;
    }
    return low;
}

}    // namespace sphonic
