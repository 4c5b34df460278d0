#pragma once
#include <cstddef>
#include <vector>

#include <sphonic/case.hpp>

#include "particle_media.hpp"
#include "store.hpp"

namespace sphonic {

/// A particle in a layer that damps.
struct Damped {
    std::ptrdiff_t at;        ///< in a field
    double rate;              ///< [1/s]
    double factor = 1;        ///< over a step
};

/// All of them, in the order of fields. `x` by axis, in particle order.
std::vector<Damped> damped_particles(const Case& scene, const ParticleMedia& media, const Layout& layout, const double* const* x);

}    // namespace sphonic
