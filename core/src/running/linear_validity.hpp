#pragma once
#include <optional>
#include <string>

#include <sphonic/case.hpp>

namespace sphonic {

/// What to say where sound is not small: p/(rho0 c0^2) or the Mach number |u|/c0 of the state, or of a wave that a source will
/// impose, is above 1e-2. What linear equations leave out is of that order of what they keep.
std::optional<std::string> beyond_linear(const Case& scene, const abi::Snapshot& shot);

}    // namespace sphonic
