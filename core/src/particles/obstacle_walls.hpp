#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <sphonic/case.hpp>

#include "mirror_particles.hpp"
#include "sites.hpp"
#include "tier.hpp"

namespace sphonic {

/// Virtual particles in the solid behind rigid and soft walls of any shape: those cut out within reach of a wall, where they were.
/// They are numbered after the set's own particles and before mirror images, some of which are of them. Their values are those
/// of the particles over the wall, as WallFit has it, by weights that are computed once. Scalars count from their rest.
class ObstacleWalls {
public:
    /// `reach` of the neighbour list [m].
    ObstacleWalls(const Case& scene, const Components& components, const Sites& sites, double reach, int threads);

    long count() const { return long(obstacle_.size()); }
    /// Coordinates go to x[a][0] and on.
    void place(double* const* x) const;
    /// Finds the weights; `x` of own, these and mirror particles.
    void fit(const double* const* x, const MirrorParticles& mirrors);
    /// Fills one scalar; a vector with its last component, those before being where they were when they were given. Says how
    /// many components were filled, the given one being the last.
    int fill(int component, double* field);
    /// Gives them the symmetric matrices of the particles at their mirror points, reflected; row a, column b >= a is entry
    /// b (b + 1)/2 + a.
    void reflect(double* const entry[6]) const;
    double bytes() const { return 28.0 * double(source_.size()) + 80.0 * double(count()); }

private:
    /// Particles that values are taken from.
    struct Sources {
        std::vector<std::int32_t> index;
        Places x;
        std::vector<double> height;    ///< over the wall [m]
    };
    /// An own particle on a wall, where what is odd vanishes.
    struct OnWall {
        std::int32_t i;
        Obstacle::Wall wall;
        double normal[3];
    };
    const Case& scene_;
    const Components& components_;
    long n_;          ///< own particles
    double reach_;    ///< [m]
    int threads_;
    Places x_, normal_;
    std::vector<double> depth_;             ///< [m]
    std::vector<std::int32_t> obstacle_;    ///< by virtual particle, ascending
    std::vector<std::int64_t> start_;       ///< first source of each, and the end
    std::vector<std::int32_t> source_, nearest_;    ///< the latter is next to the mirror point; -1 if there are none
    std::vector<double> along_, across_;            ///< by source: WallFit's weights
    std::vector<OnWall> on_;
    std::vector<double*> fields_;    ///< by component, where they were given

    void choose(const Sites& sites);
    void find_on_walls(const Sites& sites);
    Sources sources(const Obstacle& obstacle, const double* const* x, const MirrorParticles& mirrors) const;
    void fit_wall(const Obstacle& obstacle, std::size_t begin, std::size_t end, const Sources& sources);
    void fill_scalar(int component, double* field) const;
    void fill_vector(double* const* u) const;
};

}    // namespace sphonic
