#pragma once
#include "search.hpp"

namespace sphonic {

inline constexpr const char* particles_that_stay = "particles that stay";    ///< a rung's name

/// The way from a case as it was given to its plan, one change after the other; each with its predicted error and cost. Empty for a case
/// that does not run as it was given. `flat`: axes were dropped.
std::vector<Rung> ladder(const Json& given, const OpenCase& open, bool flat, const Found& planned, Registry& registry);

}    // namespace sphonic
