#include <sphonic/plugin/dissipation.hpp>

/// a_ij = c V_j |dW/dr|, by default of the strength alpha = 3.5 s, where s is the set's disorder: about the jitter in dx for the
/// cubic spline of h = 1.3 dx.
///
/// Measured with corrected forms in the plane, on lattices jittered by .05 to .3 dx and points at blue-noise distances, with kernels of
/// h/dx from 1.1 to 2 (core/decisions/0008): sets blow up below 0.8 to 2.7 s. Much more is no better: long waves then begin to
/// grow, though slowly, by some 1e-5 c0/dx.
struct FourthOrder {
    double operator()(const DampedPair& ij) const { return ij.c * ij.V * std::abs(ij.dW); }
    double strength(double disorder) const { return std::min(3.5 * disorder, 10.0); }
};

SPHONIC_DISSIPATION("fourth_order", FourthOrder, "Fourth-order dissipation for disordered sets: zero for linear fields")
