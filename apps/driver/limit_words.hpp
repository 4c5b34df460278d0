#pragma once
#include <string>

#include <sphonic/simulation.hpp>

namespace sphonic::driver {

/// What holds of a run's step, such as "stable to 0.0004 s (c0 dt/dx = 2.8)"; where the set itself grows, that no step is stable, and
/// how soon it shows.
std::string limit_words(const Case& scene, const Summary& run);

}    // namespace sphonic::driver
