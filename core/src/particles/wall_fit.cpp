#include "wall_fit.hpp"

#include <algorithm>
#include <cmath>

namespace sphonic {
namespace {

/// The unit vectors across n: one in a plane, two in space.
void span(const double* n, int dimension, std::array<double, 3>* tangent) {
    if (dimension == 2) tangent[0] = {-n[1], n[0], 0};
    if (dimension != 3) return;
    const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const std::size_t least = std::size_t(std::min_element(n, n + 3, smaller) - n);
    for (std::size_t a = 0; a < 3; ++a) tangent[0][a] = (a == least) - n[least] * n[a];
    const double length = std::hypot(tangent[0][0], tangent[0][1], tangent[0][2]);
    for (double& t : tangent[0]) t /= length;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        tangent[1][a] = n[b] * tangent[0][c] - n[c] * tangent[0][b];
    }
}

}    // namespace

WallFit::WallFit(const Case& scene, Obstacle::Wall wall, const double* normal, double depth, double curvature)
    : wall_(wall), d_(scene.box.dimension), dx_(scene.box.dx), depth_(depth / dx_), along_(wall == Obstacle::Wall::rigid ? d_ : 1),
      across_(wall == Obstacle::Wall::rigid ? 1 : d_) {
    const double most = 0.8 / (scene.radius() / dx_ + radius);    // on narrower bodies the normals spread too far for a fit
    curvature_ = std::clamp(curvature * dx_ / std::max(1, d_ - 1), -most, most);
    span(normal, d_, tangent_);
}

WallFit::Basis WallFit::across_at(const Basis& t, double z) const {
    if (wall_ == Obstacle::Wall::rigid) return {z / (1 + 0.5 * (d_ - 1) * curvature_ * z)};
    Basis thinner = t;
    for (double& value : thinner) value /= std::pow(1 + curvature_ * z, d_ - 1);
    return thinner;
}

void WallFit::add(const double* r, double z) {
    double r2 = 0;
    Basis t{1};
    for (int a = 0; a < d_; ++a) {
        r2 += r[a] * r[a];
        for (std::size_t k = 0; k + 1 < std::size_t(d_); ++k) t[k + 1] += tangent_[k][std::size_t(a)] * r[a] / dx_;
    }
    const double weight = LocalFit::closeness(std::sqrt(r2) / (radius * dx_));
    along_.add(along_at(t, z / dx_), weight);
    across_.add(across_at(t, z / dx_), weight);
}

}    // namespace sphonic
