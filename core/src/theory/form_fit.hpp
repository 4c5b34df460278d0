#pragma once
#include <sphonic/case.hpp>

namespace sphonic {

/// Asks the forms that bring weights of their own for them, at the step of the run. A case that leaves the step open gets one
/// here, for which such weights are made: c0 dt/dx = 0.9 in 1-D, 0.7 in 2-D, 0.5 in 3-D; on clouds 0.6, 0.5, 0.4.
/// A cloud gets those of its lattice, for all that is said of it before it is assembled.
void fit_forms(Case& scene);

/// True where forms will fit weights to each neighbourhood of a cloud.
bool fits_cloud(const Case& scene);

}    // namespace sphonic
