#pragma once
#include <vector>

#include "fourier.hpp"
#include "repeated_box.hpp"

namespace sphonic {

/// The initial fields of a case as Fourier components on a repeated box.
struct FieldWaves {
    std::vector<int> variables;                      ///< index of each scalar variable that the case gives
    std::vector<std::vector<Complex>> scalars, u;    ///< [field][component], [axis][component]
};
FieldWaves field_waves(const Case& scene, const RepeatedBox& box);

/// Components in the order of their power, without the weakest that together have no more than the share `left_out` of it. Of each
/// pair k, -k, conjugates of each other, one.
std::vector<long> strongest(const RepeatedBox& box, const FieldWaves& waves, double impedance, double left_out);

/// The wavelength [m] below which lies no more than `share` of the power of what a case begins with, or the shortest of its sources;
/// infinite where it is silent.
double shortest_wave(const Case& scene, double share);

}    // namespace sphonic
