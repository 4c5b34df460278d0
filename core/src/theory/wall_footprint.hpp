#pragma once
#include <vector>

#include <sphonic/stability.hpp>

namespace sphonic {

/// Weights b_m of p at the distances m dx from a rigid wall on particles, which read the wall's pressure and, over the particles'
/// share of space, put a flow there. With S(q) = sum_m b_m cos(q m) and the operator's frequency c0 F(q)/dx, such a pair acts on long
/// waves as a flow at the wall itself does, to fourth order in q but for a mass of second order, where
///   S(0) = 1,   S^2 = F'/cos(omega dt/2) + O(q^4),   f.p. integral_0^pi S^2/F^2 dq = 0   (near fields carry no mass),
/// for an integrator with 2 sin(omega dt/2)/dt = c0 F/dx. Nor must it excite the short wave q' of the same frequency, F(q') = F(q):
///   S = cos(q/2)^2n (1 + a sin(q/2)^2 + b sin(q/2)^4)
/// with the smallest n for which |S(q')| < 0.03 at 20 points per wavelength, a and b from the conditions.
std::vector<double> wall_footprint(const Case& scene, int axis, double dt);

}    // namespace sphonic
