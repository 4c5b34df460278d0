#pragma once
#include <sphonic/simulation.hpp>

namespace sphonic {

/// CPU time of a whole run [s]; `prepared` as for predict().
double predicted_seconds(const Case& scene, const Summary& prepared, bool viscous);

}    // namespace sphonic
