#pragma once
#include <vector>

#include <sphonic/plugin/abi/arrangement.hpp>

namespace sphonic {

/// Distance of each site of a lattice, x fastest, from the nearest marked one, in spacings; images in periodic axes count. Far
/// beyond the box where none is marked.
std::vector<double> distances(const abi::Box& box, const std::vector<char>& marked);

}    // namespace sphonic
