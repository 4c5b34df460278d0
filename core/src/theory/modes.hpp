#pragma once
#include <vector>

#include <sphonic/stability.hpp>

namespace sphonic {

/// The linear motions of one wave vector, or one pair of eigenvalues of a set.
struct Mode {
    Symbol symbol;
    double frequency;    ///< largest |eigenvalue| [1/s]
    double decay;        ///< most negative real part [1/s]
};

/// p and u in an oscillation that decays: p' = -omega u - delta p, u' = omega p - delta u.
Mode oscillation(const Case& scene, double omega, double delta);

/// The most demanding wave vectors of the first Brillouin zone in the most demanding medium, viscosity always on, and never.
std::vector<Mode> zone_modes(const Case& scene);

/// True where waves of single wave vectors fit into a set: a lattice of one medium between periodic faces or mirrors.
bool carries_waves(const Case& scene);
/// The wave vectors that fit, those of one octant, or of a box with very many those that zone_modes finds.
std::vector<Mode> box_modes(const Case& scene, Damping damping);

/// Largest |xi| of a step dt over the modes.
double worst_root(const Case& scene, const std::vector<Mode>& modes, double dt);
/// Largest |eigenvalue| among the modes.
double largest_frequency(const std::vector<Mode>& modes);
/// The largest step at which no mode grows, or for an integrator without one, what StepLimit says of weak growth.
StepLimit step_limit(const Case& scene, const std::vector<Mode>& modes);

}    // namespace sphonic
