#include "wall_view.hpp"

#include <cmath>

#include "neighbour_list.hpp"

namespace sphonic {

WallView::WallView(const Case& scene, const Obstacle& obstacle, const Places& x) : distance(x[0].size()) {
    abi::Points points{.dimension = scene.box.dimension, .n = int(x[0].size())};
    double* out[3] = {};
    for (int a = 0; a < scene.box.dimension; ++a) {
        points.x[a] = x[a].data();
        normal[a].resize(x[0].size());
        out[a] = normal[a].data();
    }
    obstacle.measure(scene.box, points, distance.data(), out);
}

std::vector<double> curvature(const Case& scene, const Obstacle& obstacle, const Places& x) {
    const double step = 0.05 * scene.box.dx, sharp = 0.5 / scene.box.dx;
    std::vector<double> k(x[0].size());
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const int side : {-1, 1}) {
            Places there;
            for (int b = 0; b < 3; ++b) there[b] = x[b];
            for (double& coordinate : there[a]) coordinate += side * step;
            const WallView view(scene, obstacle, there);
            for (std::size_t i = 0; i < k.size(); ++i) k[i] += side * view.normal[a][i] / (2 * step);
        }
    for (double& value : k)
        if (!(std::abs(value) < sharp)) value = 0;
    return k;
}

/// By a neighbour list over the points, to which the others are virtual particles.
Near::Near(const abi::Box& box, const Places& points, const Places& others, double radius) {
    const std::size_t n = points[0].size();
    Places all;
    const double* x[3] = {};
    for (int a = 0; a < box.dimension; ++a) {
        all[a] = points[a];
        all[a].insert(all[a].end(), others[a].begin(), others[a].end());
        x[a] = all[a].data();
    }
    start.push_back(0);
    if (n == 0) return;
    NeighbourList list(box, long(n), radius, 0);
    list.build(x, long(others[0].size()));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::int64_t k = list.start()[i]; k < list.start()[i + 1]; ++k)
            if (const std::int32_t j = list.neighbour()[std::size_t(k)]; j >= std::int32_t(n)) index.push_back(j - std::int32_t(n));
        start.push_back(std::int64_t(index.size()));
    }
}

}    // namespace sphonic
