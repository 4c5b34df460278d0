#pragma once
#include <sphonic/case.hpp>

#include "section.hpp"

namespace sphonic {

/// Reads "times" of a term: a product of constants, which each medium has of its own, and integer
/// powers of scalar variables.
void read_times(Term& term, const Case& scene, Section& section);

}    // namespace sphonic
