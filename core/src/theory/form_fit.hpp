#pragma once
#include <sphonic/case.hpp>

namespace sphonic {

/// Asks the forms that bring weights of their own for them, at the step of the run. A case that leaves the step open gets one
/// here, for which such weights are made: c0 dt/dx = 0.9 in 1-D, 0.7 in 2-D, 0.5 in 3-D.
void fit_forms(Case& scene);

}    // namespace sphonic
