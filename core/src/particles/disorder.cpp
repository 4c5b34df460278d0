#include "disorder.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "neighbour_list.hpp"
#include "sites.hpp"

namespace sphonic {
namespace {

constexpr double median_of_normal = 0.6745;    ///< of the magnitude, over the standard deviation
constexpr double rounding = 1e-9;

/// The pairs of one particle.
class Row {
public:
    Row(const Case& scene, const KernelUse& kernel, const NeighbourList& list, const double* const* x)
        : scene_(scene), kernel_(kernel), list_(list), x_(x) {}

    void start(long i) {
        const std::int64_t first = list_.start()[std::size_t(i)], last = list_.start()[std::size_t(i) + 1];
        distance_.assign(std::size_t(last - first), 0.0);
        W_.resize(distance_.size());
        slope_.resize(distance_.size());
        for (int a = 0; a < scene_.box.dimension; ++a) {
            r_[a].clear();
            for (std::int64_t k = first; k < last; ++k) {
                const double r = list_.period(a).nearest(x_[a][i] - x_[a][list_.neighbour()[std::size_t(k)]]);
                r_[a].push_back(r);
                distance_[std::size_t(k - first)] += r * r;
            }
        }
        for (double& r : distance_) r = std::sqrt(r);
        kernel_.kernel->evaluate(scene_.box.dimension, int(distance_.size()), distance_.data(), kernel_.h, W_.data(), slope_.data());
    }
    /// sum_j V_j d_a W_ij [1/m]
    double derivative_of_one(int axis) const {
        double sum = 0;
        for (std::size_t k = 0; k < slope_.size(); ++k) sum += slope_[k] * r_[axis][k];
        return scene_.particle_volume() * sum;
    }
    /// sum_j V_j W_ij (x_j - x_i)_a^2 [m^2]
    double second_moment(int axis) const {
        double sum = 0;
        for (std::size_t k = 0; k < W_.size(); ++k) sum += W_[k] * r_[axis][k] * r_[axis][k];
        return scene_.particle_volume() * sum;
    }

private:
    const Case& scene_;
    const KernelUse& kernel_;
    const NeighbourList& list_;
    const double* const* x_;
    std::vector<double> r_[3], distance_, W_, slope_;
};

double median(std::vector<double>& values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

bool within(const Case& scene, int axis, double x, double margin) {
    return scene.box.periodic[axis] || (x >= scene.box.lower[axis] + margin && x <= scene.box.upper[axis] - margin);
}

}    // namespace

std::optional<double> disorder(const Case& scene, const KernelUse& kernel) {
    if (scene.regular()) return 0;
    const Sites sites(scene);
    const long n = sites.count();
    const double* const x[3] = {sites.own[0].data(), sites.own[1].data(), sites.own[2].data()};
    NeighbourList list(scene.box, n, kernel.radius(), 0);
    list.build(x, 0);
    Row row(scene, kernel, list, x);
    std::vector<double> sizes, widths;
    for (long i = 0; i < n; ++i) {
        row.start(i);
        for (int a = 0; a < scene.box.dimension; ++a)
            if (within(scene, a, x[a][i], kernel.radius())) {
                sizes.push_back(std::abs(row.derivative_of_one(a)));
                widths.push_back(row.second_moment(a));
            }
    }
    if (sizes.empty()) return std::nullopt;
    const double found = std::sqrt(std::max(0.0, median(widths))) * median(sizes) / median_of_normal;
    return found < rounding ? 0 : found;
}

}    // namespace sphonic
