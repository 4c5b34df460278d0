#pragma once
#include <vector>

#include "mirror_particles.hpp"
#include "obstacle_walls.hpp"
#include "sites.hpp"
#include "store.hpp"

namespace sphonic {

/// The virtual particles of a set with a neighbour list: those behind the walls of obstacles, numbered after its own, then mirror
/// images of both behind the faces of the box. What lies behind obstacles may take its values from images of the set's own.
class VirtualParticles {
public:
    /// `x` by axis, of the set's own particles; `reach` of the neighbour list [m].
    VirtualParticles(const Case& scene, const Components& components, const Sites& sites, const double* const* x, double reach, bool frozen, int threads);

    const ObstacleWalls& walls() const { return walls_; }
    const MirrorParticles& mirrors() const { return mirrors_; }
    long count() const { return walls_.count() + mirrors_.count(); }
    /// That there is room for: a set that moves may come to need more than now.
    long room() const { return room_; }

    /// The set's own particles are at `x` now: where all are then, by axis.
    void follow(const double* const* x);
    const double* x(int axis) const { return x_[axis]; }
    /// Chooses mirror images anew for the present positions, with values as their sources have them.
    void renew();
    /// Fills one component. A vector's virtual values are right once its last component was filled.
    void fill(int component, double* field);
    double bytes() const;

private:
    const Case& scene_;
    long n_;          ///< own particles
    double reach_;    ///< [m]
    int threads_;
    ObstacleWalls walls_;
    MirrorParticles mirrors_;
    long room_ = 0;
    Array position_[3];              ///< of own and virtual particles, where there are any
    const double* x_[3] = {};
    std::vector<double*> fields_;    ///< by component, where the state lies

    bool needed() const { return walls_.count() > 0 || mirrors_.needed(); }
};

}    // namespace sphonic
