#pragma once
#include <optional>
#include <vector>

#include <sphonic/case.hpp>

namespace sphonic {

/// The equations of a case, linearised at rest on its infinite lattice, for one wave vector:
/// z' = A z for z = (scalars, vectors / i), a real matrix, row-major, n x n.
struct Symbol {
    int n = 0;
    std::vector<double> a;
};

/// `k` [rad/m] has `dimension` entries. Viscosity enters as always switched on, times `viscosity`. In one of the case's media.
Symbol symbol(const Case& scene, const double* k, double viscosity = 1, int medium = 0);

/// Speed of a long wave along `direction` (unit vector), over c0: the limit of omega/(c0 k) for k -> 0, without viscosity.
/// In the first medium.
double long_wave_speed(const Case& scene, const double* direction);

/// omega(k)/c0 [rad/m] of the discrete operator along `direction`: its largest frequency at that wave vector, in the first medium.
double dispersion(const Case& scene, double k, const double* direction);

/// Largest |eigenvalue| of the one-step map of the case's integrator over the sampled wave vectors, in the most demanding medium.
double amplification(const Case& scene, double dt);

struct StepLimit {
    double dt = 0;         ///< largest stable step [s]; 0 where growth cannot be kept small by any useful step
    double frequency = 0;  ///< largest of the operator's over the zone [1/s]
    bool weak = false;     ///< the integrator grows at any step: dt is where the worst mode grows by e^12 within `until`
};

/// The largest omega dt that the case's integrator bears for an undamped oscillation of p and u; 0 where it grows at any step.
double oscillator_limit(const Case& scene);

/// The largest stable step of the case on its lattice, with viscosity always on, in the most demanding medium.
StepLimit step_limit(const Case& scene);

/// True if the case's integrator passes through states within a step that it does not keep: walls with memory cannot follow it.
bool works_in_stages(const Case& scene);

/// How the case's lattice and integrator carry a steady tone at step dt, mean over axis and diagonals; nothing where no wave
/// of that frequency travels. Without viscosity.
std::optional<abi::ToneResponse> tone_response(const Case& scene, double omega, double dt, int medium = 0);

}    // namespace sphonic
