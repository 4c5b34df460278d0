#pragma once
#include <string>

#include <sphonic/cost_model.hpp>
#include <sphonic/simulation.hpp>

namespace sphonic {

/// What decides the cost of a set's steps.
struct Work {
    std::string tier;            ///< as cost models name it
    int dimension = 1;
    double particles = 0, neighbours = 0;
    double row = 1e9;            ///< particles to a row of a lattice
    double interfaces = 0;       ///< between media, across its rows
    bool viscous = false;
    double evaluations = 1, calls = 1;    ///< in a step: of all equations together, and calls for the rate of some
};

/// CPU time of a step [ns].
double step_cost(const CostModel& costs, const Work& work);
/// Particle-evaluations that a step is worth: rows have ends, and where pairs are found anew each call pays for them.
double worth(const Work& work);
/// Bytes that a step passes through.
double footprint(const Work& work);

/// The name of a set's tier in cost models, where what its equations ask for makes a difference.
std::string cost_tier(const Case& scene, const std::string& tier, double neighbours);

/// Is a set of this tier stepped along the rows of a lattice or a grid?
bool on_rows(const std::string& tier);

/// CPU time of a whole run [s]; `prepared` as for predict().
double predicted_seconds(const CostModel& costs, const Case& scene, const Summary& prepared, bool viscous);

}    // namespace sphonic
