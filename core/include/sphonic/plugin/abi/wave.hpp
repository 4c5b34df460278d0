#pragma once
#include <cmath>

#include <sphonic/plugin/abi/state.hpp>

namespace sphonic::abi {

/// A block of n points: coordinate a of point i is x[a][i] [m]; null beyond the dimension.
struct Points {
    int dimension = 1;
    int n = 0;
    const double* x[3] = {nullptr, nullptr, nullptr};
};

/// Values of an acoustic field at points; a null array is not wanted.
struct AcousticField {
    double* p = nullptr;                           ///< sound pressure [Pa]
    double* u[3] = {nullptr, nullptr, nullptr};    ///< particle velocity [m/s]
};

/// Height, 0 to 1, of a tone that swells by half a cosine over so many periods, at a phase [rad] from its beginning; silent before it.
inline double swelling(double phase, double periods) {
    constexpr double pi = 3.14159265358979323846;
    const double end = 2 * pi * periods;
    if (periods == 0 || phase >= end) return 1;
    return phase <= 0 ? 0 : 0.5 - 0.5 * std::cos(pi * phase / end);
}

/// A plane wave p = amplitude sin(phase), phase = omega t - k . (x - origin), k = omega / c0 along `direction` (a unit vector).
struct PlaneWave {
    double amplitude = 0;    ///< [Pa]
    double omega = 0;        ///< [rad/s]
    double direction[3] = {1, 0, 0};
    double origin[3] = {0, 0, 0};    ///< [m]
    double swell = 0;                ///< periods behind the front over which it reaches its amplitude

    /// [Pa]
    double pressure(double phase) const { return amplitude * swelling(phase, swell) * std::sin(phase); }
};

}    // namespace sphonic::abi
