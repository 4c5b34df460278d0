#pragma once
#include <memory>
#include <vector>

#include "particle_system.hpp"

namespace sphonic {

/// One step of a set under the case's integrator as a linear map of all that it depends on: fields, histories, ghosts, and what walls
/// remember. Linearised at rest; its eigenvalues xi are the factors of motions in a step.
class StepMap {
public:
    explicit StepMap(const Case& scene);

    /// Largest |xi| of a step dt [s].
    double largest_root(double dt);
    /// Largest dt up to which no |xi| exceeds 1, found upwards from steps far below 1/omega [s]; 0 if none is stable.
    double last_stable(double omega);

private:
    const Case& scene_;
    ParticleSystem system_;
    bool viscous_;
    std::vector<std::span<double>> all_;
    std::vector<double> rest_, unit_;    ///< of each value
    double dt_ = 0;
    long index_ = 0;

    void begin(double dt);
    void step();
    void apply(const double* x, double* y, int steps);
    double root_of_all();
    double root_by_repetition();
};

}    // namespace sphonic
