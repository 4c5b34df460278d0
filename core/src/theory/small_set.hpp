#pragma once
#include <optional>

#include <sphonic/case.hpp>

namespace sphonic {

/// A small set of the same make as a case's: its spacing, disorder, seed, kernels, forms, media, walls and integrator at the step dt [s],
/// without its sources, obstacles and initial fields. Its box is a piece of the case's of about ten spacings a side (forty in 1-D), wider
/// where the kernel asks for it; of several media the piece about the strongest jump of impedance. A layer that damps leaves the wall
/// behind it, and a free face is rigid where sources set what is there, or it is solid. With `closed` all free
/// faces are. The set itself where it is no larger; nothing where an arrangement fills no smaller box.
std::optional<Case> small_set(const Case& scene, double dt, bool closed = false);

}    // namespace sphonic
