#pragma once
#include <optional>
#include <span>
#include <vector>

#include <sphonic/case.hpp>

#include "lattice_tiles.hpp"
#include "particle_media.hpp"
#include "store.hpp"
#include "tier.hpp"

namespace sphonic {

/// What lies beyond the faces of a lattice: periodic images, mirror images, layers that a boundary plugin fills. Axes in turn,
/// each with the ghosts of those before it, so that edges and corners are right.
class LatticeGhosts {
public:
    LatticeGhosts(const Case& scene, const Components& components, const ParticleMedia& media, const Layout& layout, const LatticeTiles& tiles, int threads);

    /// Fills the ghosts of one component, whose values are those of time t [s], of faces that what is stepped comes near to; walls with memory always. `pressure` is that of p, as it stands.
    template <class Real>
    void fill(int component, Real* field, const Real* pressure, double t);
    /// Forgets what layers with memory were before.
    void restart();
    /// What they now were.
    std::vector<std::span<double>> remembered();

private:
    /// Values by layer and column.
    struct Rows {
        Rows(long layers, long columns);
        std::vector<std::vector<double>> values;
        std::vector<double*> pointers;
        /// Those of the columns from one on.
        std::vector<double*> from(long column);
    };
    /// Consecutive columns whose last particles are of one medium.
    struct Stretch {
        int medium;
        long first, n;
    };
    /// One face's layers of one component, and what the wall remembers of them.
    struct Memory {
        Memory(long layers, long columns);
        /// Begins a call for time t [s], or begins the last one anew if it was for the same; returns the time since the one before.
        double begin(double t);
        std::optional<double> last, one_before;    ///< times of calls [s]
        std::vector<Stretch> stretches;
        Rows inner, pressure, kept, kept_before, ghost;
    };
    const Case& scene_;
    const Components& components_;
    const ParticleMedia& media_;
    const Layout layout_;
    const LatticeTiles& tiles_;
    int threads_;
    std::vector<std::unique_ptr<Memory>> memory_;    ///< [component][axis][upper], where a face has layers

    long columns(int axis) const;
    std::vector<Stretch> stretches(int axis, bool upper) const;
    bool worthwhile(int axis) const;
    bool reached(int axis, bool upper) const;
    template <class Real, class Line>
    void for_lines(Real* field, int axis, Line line) const;
    template <class Real>
    void wrap(Real* field, int axis) const;
    template <class Real>
    void mirror(Real* field, int component, int axis, bool upper) const;
    template <class Real>
    void layers(Real* field, const Real* pressure, int component, double t, int axis, bool upper);
};

}    // namespace sphonic
