#pragma once
#include <vector>

#include "open_case.hpp"

namespace sphonic {

/// Spacings [m] from coarse to fine, by a tenth or a twentieth each, at which both ends of every closed axis lie on particles; of several media each
/// with the next three. The case's own, if it decides.
std::vector<double> spacings(const OpenCase& open, double coarsest, double most_particles);
/// Those of the kind that lie between two of them, at most three, from coarse to fine.
std::vector<double> spacings_between(const OpenCase& open, double coarser, double finer);
/// Gives the media of a document spacings in proportion to the speed of their sound, near `dx` [m] for the first, such that interfaces
/// lie half-way between particles; that of the first.
double spread(const OpenCase& open, double dx, Json& document);

}    // namespace sphonic
