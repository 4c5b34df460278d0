#pragma once
/// Vector parameters of a plugin against the space of a case. Both functions throw std::invalid_argument with a remedy.

#include <cmath>
#include <stdexcept>
#include <string>

#include <sphonic/plugin/parameter.hpp>

namespace sphonic {

/// A vector that was given has as many components as the space.
inline void require_components(const char* name, const Vector& given, int dimension) {
    if (given.size != 0 && given.size != dimension) throw std::invalid_argument(std::string(name) + " needs one component per dimension");
}

/// The unit vector along `given`, one component per dimension; along +x if it was not given.
inline Vector unit_direction(const Vector& given, int dimension) {
    require_components("direction", given, dimension);
    if (given.size == 0) return {{1, 0, 0}, dimension};
    const double length = std::hypot(given.v[0], given.v[1], given.v[2]);
    if (!(length > 0)) throw std::invalid_argument("direction has no length: give a vector other than zero");
    return {{given.v[0] / length, given.v[1] / length, given.v[2] / length}, dimension};
}

}    // namespace sphonic
