#pragma once
#include <vector>

#include <sphonic/case.hpp>

namespace sphonic {

/// One neighbour of a lattice particle, at x_j = x_i + o dx, and the weights of the pair.
struct Offset {
    int o[3] = {0, 0, 0};
    double r2 = 0;                    ///< |r_ij|^2 [m^2]
    double slope = 0;                 ///< (dW/dr)/r [m^-(d+2)]
    double gradient[3] = {0, 0, 0};   ///< grad_i W_ij [m^-(d+1)]
};

/// All neighbours within the kernel's support, those with W' = 0 at the rim left out. Ordered; o and -o both there.
std::vector<Offset> lattice_neighbours(const abi::Box& box, const KernelUse& kernel);
/// One of each pair o, -o.
std::vector<Offset> half_neighbours(const std::vector<Offset>& all);

/// Coefficients of a form between particles of two media at rest.
struct RestCoefficients {
    double own, other;
};
RestCoefficients rest_coefficients(const abi::Form& form, abi::Derivative derivative, const abi::Medium& i, const abi::Medium& j);
abi::Derivative derivative(const Term& term);

/// V grad_i W_ij of a term's neighbours in the interior of a medium's lattice, corrected as its form asks for, and always
/// without one: `neighbours` with other gradients, or the form's own. Throws if the neighbourhood is degenerate.
std::vector<Offset> weighted_neighbours(const Case& scene, const Term& term, std::vector<Offset> neighbours, int medium = 0);

/// a_ij of a dissipation for lattice pairs in the first medium at rest [1/s].
std::vector<double> rest_couplings(const abi::Dissipation& dissipation, const Case& scene, const KernelUse& kernel, const std::vector<Offset>& pairs);

/// Slope dPi/d(u.r) of a viscosity for a lattice pair of approaching particles at rest.
double rest_slope(const abi::Viscosity& viscosity, const Case& scene, const KernelUse& kernel, double r2);

/// Particle volume [m^d].
double lattice_volume(const abi::Box& box);

}    // namespace sphonic
