#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include <sphonic/case.hpp>

#include "sites.hpp"

namespace sphonic {

/// How points lie to one obstacle's wall.
struct WallView {
    std::vector<double> distance;    ///< [m], positive in the fluid
    Places normal;                   ///< unit, into the fluid

    WallView(const Case& scene, const Obstacle& obstacle, const Places& x);
};

/// Divergence of the normals [1/m] at points of a wall: 1/a on a circle of radius a with the fluid around it, -1/a with the
/// fluid in it; zero at corners.
std::vector<double> curvature(const Case& scene, const Obstacle& obstacle, const Places& x);

/// A difference of two points along an axis: to the nearest image, where the axis is periodic.
inline double apart(const abi::Box& box, int axis, double r) {
    const double period = box.upper[axis] - box.lower[axis];
    return box.periodic[axis] ? r - period * std::nearbyint(r / period) : r;
}

/// For each of some points the others within a radius, in ascending order.
struct Near {
    std::vector<std::int64_t> start;    ///< [points + 1]
    std::vector<std::int32_t> index;

    Near(const abi::Box& box, const Places& points, const Places& others, double radius);
};

}    // namespace sphonic
