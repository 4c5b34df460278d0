#pragma once
#include <string>

#include <sphonic/case.hpp>

namespace sphonic {

enum class Pairing { plain, corrected };

/// Sound of c0 = 1 m/s on a periodic lattice of spacing 1 m with a kernel at its parameters' defaults.
Case kernel_case(Registry& registry, const std::string& kernel, int dimension, double h_over_dx, Pairing forms, const std::string& integrator = "leapfrog");

}    // namespace sphonic
