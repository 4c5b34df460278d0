#pragma once
#include <sphonic/case.hpp>

namespace sphonic {

/// Takes a case that was read in x over into the coordinate of its stretch: box, media, coefficients, sources and faces.
void enter(Case& scene);

}    // namespace sphonic
