#pragma once
#include <optional>

#include <sphonic/case.hpp>

namespace sphonic {

/// How far a set, as it begins, is from one whose neighbourhoods are symmetric: the root mean square over particles and axes a of
/// |l sum_j V_j d_a W_ij|, the kernel's derivative of a constant over its width, l^2 = sum_j V_j W_ij (x_j - x_i)_a^2; 0 on any lattice,
/// in 2-D 0.28 of the jitter [dx] for the cubic spline of h = 1.3 dx. Taken from medians, which the ends of a set hardly change, as of
/// a normal distribution. Nothing where no particle has neighbours on both sides along an axis.
std::optional<double> disorder(const Case& scene, const KernelUse& kernel);

}    // namespace sphonic
