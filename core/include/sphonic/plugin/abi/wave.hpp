#pragma once
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

/// A plane wave p = amplitude sin(omega t - k . (x - origin)), k = omega / c0 along `direction` (a unit vector).
struct PlaneWave {
    double amplitude = 0;    ///< [Pa]
    double omega = 0;        ///< [rad/s]
    double direction[3] = {1, 0, 0};
    double origin[3] = {0, 0, 0};    ///< [m]
};

}    // namespace sphonic::abi
