#pragma once
#include <algorithm>
#include <vector>

#include <sphonic/plugin/point_set.hpp>

namespace staggered {

using sphonic::PointSet;

/// The body that each point lies in.
inline std::vector<abi::Body> bodies_at(const abi::Scene& scene, const PointSet& set) {
    std::vector<abi::Body> found(set.at.size(), abi::Body::none);
    if (scene.bodies) scene.bodies(scene.host, set.points(), found.data());
    return found;
}

/// The points of a set that lie in no body.
inline PointSet outside_bodies(const abi::Scene& scene, const PointSet& set) {
    const auto found = bodies_at(scene, set);
    std::vector<unsigned char> outside(found.size());
    std::transform(found.begin(), found.end(), outside.begin(), [](abi::Body b) { return b == abi::Body::none; });
    return set.kept(outside);
}

}    // namespace staggered
