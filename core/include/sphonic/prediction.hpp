#pragma once
#include <optional>
#include <string>
#include <vector>

#include <sphonic/simulation.hpp>

namespace sphonic {

/// What a case will give, from theory alone.
struct Prediction {
    std::optional<double> speed_error;    ///< of a long wave along the source's direction: c/c0 - 1, as the step goes to zero
    std::optional<double> l2;             ///< phase and amplitude error of the sources' waves over c0 * until
    double cpu_s = 0;                     ///< from the tier's cost per pair on the reference machine
    double memory_bytes = 0;
    std::vector<std::string> warnings;
    std::string basis;                    ///< what l2 and cpu_s rest on
};

/// `prepared` is the summary of a simulation that was made ready but not run.
Prediction predict(const Case& scene, const Summary& prepared);

/// One step's amplification of the travelling wave of wave number k [rad/m] along `direction`:
/// its numerical frequency [rad/s] and decay rate [1/s], with the case's integrator at step dt. Viscosity is taken at
/// `viscosity` times what it is when always on: Monaghan's acts half of the time.
struct TravellingMode {
    double omega, decay;
};
TravellingMode travelling_mode(const Case& scene, double k, const double* direction, double dt, double viscosity, int medium = 0);

}    // namespace sphonic
