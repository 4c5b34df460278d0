#pragma once
#include <optional>

#include <sphonic/case.hpp>

namespace sphonic {

/// The wave number [rad/m] that travels with frequency `omega` [rad/s] along `direction` (unit vector) at step dt, on the branch that
/// begins at k = 0; nothing where omega is beyond the `top` of the band [rad/s].
std::optional<double> carried_wave_number(const Case& scene, double omega, const double* direction, double dt, int medium, double* top = nullptr);

}    // namespace sphonic
