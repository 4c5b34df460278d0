#pragma once
#include <optional>
#include <string>
#include <vector>

#include <sphonic/simulation.hpp>
#include <sphonic/stability.hpp>

namespace sphonic {

/// What comes back from a layer that damps, in dB below what meets it.
struct LayerReturn {
    std::string face;                  ///< such as "x_max"
    double omega;                      ///< of the sound [rad/s]
    double normal = 0, oblique = 0;    ///< at right angles, and at `oblique_angle` to them [dB]
};
inline constexpr double oblique_angle = 60;    ///< [degrees]

/// The amplitude that a layer on a face returns of a plane wave of frequency omega [rad/s] at an angle [rad] to the normal, over
/// the wave's: that of the continuous equations
///   (i omega + sigma) p = -rho0 c0^2 div u,   (i omega + sigma) rho0 u = -grad p
/// along the normal, `thickness` [m] before a rigid wall.
double layer_return(const abi::Boundary& layer, const abi::Medium& medium, double thickness, double omega, double angle);

/// Those of all faces, in the first medium.
std::vector<LayerReturn> layer_returns(const Case& scene);

/// What a case will give, from theory, and where that does not reach by trial.
struct Prediction {
    std::optional<double> speed_error;    ///< of a long wave along the source's direction: c/c0 - 1, as the step goes to zero
    std::optional<double> rounding;       ///< relative error of single precision alone
    std::optional<double> l2;             ///< phase and amplitude error of the sources' waves over c0 * until
    bool estimated = false;               ///< l2 is from runs at coarser spacings: good to a factor of some two
    double cpu_s = 0;                     ///< from the tier's cost per pair on the reference machine
    double memory_bytes = 0;
    std::vector<LayerReturn> layers;      ///< at the lowest tone of the sources, else where the layer is a wavelength thick
    std::vector<std::string> warnings;
    std::string basis;                    ///< what l2 and cpu_s rest on
};

/// Relative error of fields of single precision after so many steps, in order of magnitude: each step rounds each value by up to half of
/// 2^-23, as a walk at random does; weights so rounded add a phase of 2^-24 times that of the wave.
double rounding_floor(long steps);

/// Whether the same case may be run at coarser spacings, a second at most each, for what theory does not know.
enum class Trials { none, allowed };

/// `prepared` is the summary of a simulation that was made ready but not run.
Prediction predict(const Case& scene, const Summary& prepared, Trials trials = Trials::none);

/// What of the sources' highest frequencies travels 2 % slower or faster than long waves, or not at all at step dt, in the medium where it is
/// worst: points per wavelength, and what to do. Imposed fields whose frequency is not known are listened to.
std::vector<std::string> source_warnings(const Case& scene, double dt);

/// One step's amplification of the travelling wave of wave number k [rad/m] along `direction`:
/// its numerical frequency [rad/s] and decay rate [1/s], with the case's integrator at step dt. Monaghan's viscosity acts half
/// of the time: take half of it.
struct TravellingMode {
    double omega, decay;
};
TravellingMode travelling_mode(const Case& scene, double k, const double* direction, double dt, Damping damping, int medium = 0);

}    // namespace sphonic
