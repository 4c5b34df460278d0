#pragma once
#include <optional>
#include <vector>

#include <sphonic/case.hpp>

namespace sphonic {

/// The relative L2 error at `until`, from theory alone, of plane waves that leave their sources' regions from t = 0 on, in the region
/// of the case's reference. Each frequency of a wave's beginning goes at the speed and decay that the set gives it:
///   p(s, T) = sum_m S_m exp(i omega_m T - i k(omega_m) s - decay(omega_m) s),
/// s along the path, S the spectrum of what the region's edge sends. Frequencies beyond the set's largest do not travel. `senders` are
/// sources that have a wave. Nothing for very long runs.
std::optional<double> fronts_error(const Case& scene, const std::vector<const SourceUse*>& senders, double dt);

}    // namespace sphonic
