#pragma once
#include <string>

#include <sphonic/cost_model.hpp>
#include <sphonic/simulation.hpp>

namespace sphonic {

/// CPU time per point and step of what passes over a set's fields beside the step's own: layers, and on grids sources, bodies and media [ns].
double passes(const CostModel& costs, const Case& scene, const Summary& prepared);

/// How many times the cost of a well-divisible size a spectral method's transforms take; 1 for others.
double transform_factor(const Case& scene, const std::string& tier);

}    // namespace sphonic
