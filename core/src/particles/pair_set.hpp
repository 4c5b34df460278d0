#pragma once
#include <vector>

#include <sphonic/case.hpp>

#include "mirror_particles.hpp"
#include "near_pairs.hpp"
#include "obstacle_walls.hpp"
#include "pair_tile.hpp"
#include "tier.hpp"

namespace sphonic {

inline constexpr long pairs_per_tile = 288;    ///< some twenty arrays of this length stay in the first-level cache

/// Separations and kernel slopes of consecutive pairs; those of a frozen set are kept for the whole run.
struct PairGeometry {
    Array r[3];                    ///< r_ij by axis [m]
    Array r2;                      ///< [m^2]
    std::vector<Array> slope;      ///< (dW/dr)/r by kernel [m^-(d+2)]
};

/// What the programs of one set with a neighbour list share.
struct PairSet {
    const Case& scene;
    const Components& components;
    const ParticleMedia& media;
    Layout layout;
    NeighbourList list;
    NearPairs near;                   ///< of the list
    const ObstacleWalls& walls;
    const MirrorParticles& mirrors;
    const double* x[3] = {};          ///< by axis, of own and virtual particles
    int threads = 1;
    double mass = 0;                  ///< [kg], the same for all
    double volume = 0;                ///< [m^d], where there is no current density
    const PairGeometry* kept = nullptr;    ///< of all pairs, on frozen sets

    /// The medium of an own or virtual particle.
    int medium(long j) const { return media.number(mirrors.source(j)); }
    /// The variable rho where volumes and forms follow it: on moving sets. Frozen geometry is that of rest.
    int density() const { return kept ? -1 : scene.equations.density; }
};

/// The i-th tile of the pairs that are near.
void take_tile(const PairSet& set, long i, PairTile& tile);
inline long tiles(const PairSet& set) { return set.near.tiles(); }

/// 1/rho of n particles.
void invert(int threads, long n, const double* rho, double* inverse);

/// What pairs take from their particles: positions, some components of a state, and 1/rho where the set has a current density.
class PairFields {
public:
    /// `components` by their places in the states that evaluations begin with.
    PairFields(const PairSet& set, std::vector<int> components) : set_(set), components_(std::move(components)) {}

    /// Takes over present values, once per evaluation; `inverse_rho` of all particles, or null.
    void fill(const double* const* state, const double* inverse_rho);

    const std::vector<int>& components() const { return components_; }
    bool has_inverse_rho() const { return inverse_rho_; }
    /// Positions by axis where geometry is not kept, the components, and 1/rho, if any.
    const std::vector<const double*>& sources() const { return sources_; }
    /// Four sources each.
    const std::vector<Interleaved>& parts() const { return parts_; }

private:
    const PairSet& set_;
    std::vector<int> components_;
    bool inverse_rho_ = false;
    std::vector<const double*> sources_;
    std::vector<Interleaved> parts_;
};

/// Per-pair values of a tile: separations, kernel slopes, and both sides' values of the components in use.
class PairValues {
public:
    /// `fields` are filled before each evaluation.
    PairValues(const PairSet& set, const PairFields& fields);

    void start(const PairTile& tile);

    int n() const { return tile_->n; }
    const double* r(int axis) const { return r_[axis]; }
    const double* r2() const { return r2_; }
    /// (dW/dr)/r, and the same times V_j.
    const double* slope(int kernel) const { return slope_[std::size_t(kernel)]; }
    const double* weight(int kernel) const { return weight_[std::size_t(kernel)].data(); }
    const double* own(int component) const { return own_[std::size_t(component)].data(); }
    const double* other(int component) const { return other_[std::size_t(component)].data(); }
    const double* own_inverse_rho() const { return own_.back().data(); }
    const double* other_inverse_rho() const { return other_.back().data(); }
    /// A scratch array of the tile's length.
    double* room(Array& array) const;

private:
    const PairSet& set_;
    const PairFields& fields_;
    const PairTile* tile_ = nullptr;
    PairGeometry computed_;
    const double *r_[3] = {}, *r2_ = nullptr;    ///< into the computed or the kept geometry
    std::vector<const double*> slope_;
    Array distance_, unused_;
    std::vector<Array> weight_, own_, other_;
    std::vector<double*> own_of_, other_of_;    ///< by source of the fields; positions have no `own`, their difference is `other`

    void make_room();
    void pack();
    template <int W, int positions>
    void pack_part(std::size_t part) const;
    void compute_geometry();
    void point_to(const PairGeometry& geometry, std::int64_t offset);
    void weigh(double* weight, const double* slope) const;
};

/// The geometry of all pairs of a set that will not move.
PairGeometry keep_geometry(const PairSet& set);

/// Some terms of one variable, which a program evaluates.
struct Share {
    int variable;
    std::vector<const Term*> terms;
};
/// All terms of some variables.
std::vector<Share> whole_shares(const Equations& equations, const std::vector<int>& variables);

/// In pair_program.cpp.
std::unique_ptr<Program> make_pair_program(const PairSet& set, const std::vector<Share>& shares);

}    // namespace sphonic
