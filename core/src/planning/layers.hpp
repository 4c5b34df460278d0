#pragma once
#include <vector>

#include "judge.hpp"
#include "open_case.hpp"

namespace sphonic {

/// Open layers return 6 dB less than the target at right angles; a warning of given ones that return more. The places of the open ones.
std::vector<std::size_t> fit_layers(OpenCase& open, const PlanRequest& request, Plan& plan);

/// What layers return beyond that, of sound that meets them aslant or is longer than they are thick, shows in a run: of the cheapest
/// set-up that theory follows, what it errs beyond theory. Open layers become weaker, for they then return less at once, until that
/// stays below half of the target, or to the best of those tried. The judge adds it to its theory.
void weigh_layers(OpenCase& open, const std::vector<std::size_t>& fitted, double target, double shortest, Judge& judge, Plan& plan);

}    // namespace sphonic
