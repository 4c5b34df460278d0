#pragma once
#include <vector>

#include <sphonic/case.hpp>

#include "particle_media.hpp"

namespace sphonic {

/// Points by axis [m].
using Places = std::vector<double>[3];

/// Where a case's particles lie: the arrangement's sites, displaced by its jitter, without those in obstacles. A particle whose
/// centre is on a wall stays.
struct Sites {
    Places own;
    Places solid;    ///< those cut out, in the same order
    std::vector<long> cut;    ///< how many are in each obstacle

    explicit Sites(const Case& scene);
    long count() const { return long(own[0].size()); }

private:
    void separate(const Case& scene, Places& all);
};

/// The medium of each particle of a set, and as `x` its places, with room for what vectors read beyond the last.
ParticleMedia place_particles(const Case& scene, const Sites& sites, Places& x);

/// A share of the spacing below which points count as being on a wall.
inline constexpr double on_wall = 1e-6;

}    // namespace sphonic
