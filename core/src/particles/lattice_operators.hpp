#pragma once
#include <array>
#include <memory>
#include <vector>

#include <sphonic/case.hpp>

#include "lattice_tiles.hpp"
#include "parallel.hpp"
#include "particle_media.hpp"
#include "stencil.hpp"
#include "store.hpp"
#include "tier.hpp"

namespace sphonic {

/// What all operators of one lattice share.
struct LatticeGrid {
    /// For fields of vectors of `line` values.
    explicit LatticeGrid(const Case& scene, const ParticleMedia& media, long line = 8);

    const Case& scene;
    const ParticleMedia& media;
    Layout layout;
    LatticeTiles tiles;    ///< what is stepped
    int threads;
    std::vector<std::vector<Offset>> neighbours{};    ///< by kernel

    int medium(const std::array<long, 3>& site) const {
        return media.number(site[0] + layout.count[0] * (site[1] + layout.count[1] * site[2]));
    }
    /// Calls block(stretch) for consecutive particles that are stepped, over all rows.
    template <class Block>
    void for_stretches(Block block) const {
        tiles.for_stretches(threads, block);
    }
    /// Calls block(medium, offset in the field, particles) for consecutive particles of one medium that are stepped, over all rows.
    template <class Block>
    void for_blocks(Block block) const {
        for_stretches([&](const LatticeTiles::Stretch& s) {
            if (!media.several()) return block(0, s.offset, s.n);
            const auto beyond = [](std::ptrdiff_t place, const Stretch& m) { return place < m.offset; };
            for (auto m = std::upper_bound(stretches_.begin(), stretches_.end(), s.offset, beyond) - 1; m != stretches_.end() && m->offset < s.offset + s.n; ++m) {
                const long begin = std::max(m->offset, long(s.offset)), end = std::min(m->offset + m->n, long(s.offset + s.n));
                if (begin < end) block(m->medium, begin, end - begin);
            }
        });
    }

    /// Without the ends of a bounded set, where particles have fewer.
    double neighbours_mean() const;

    std::ptrdiff_t stride(const Offset& n) const {
        return n.o[0] + n.o[1] * layout.stride[1] + n.o[2] * layout.stride[2];
    }
    /// True where the set simply ends.
    bool open(int axis, bool upper) const { return scene.closure(axis, upper) == abi::Closure::free; }
    /// Sites whose neighbour at `n` exists along an axis, as a particle or as a ghost: [first, last).
    std::pair<long, long> reachable(const Offset& n, int axis) const {
        if (axis >= layout.dimension) return {0, 1};
        const long count = layout.count[axis];
        return {open(axis, false) ? std::max(0L, long(-n.o[axis])) : 0, open(axis, true) ? std::min(count, count - n.o[axis]) : count};
    }

private:
    struct Stretch {
        int medium;
        long offset, n;
    };
    std::vector<Stretch> stretches_;    ///< of one medium each, where there are several
};

/// One term of one variable on a lattice.
template <class Real>
class LatticeTerm {
public:
    virtual ~LatticeTerm() = default;
    virtual void apply(const EvaluationOf<Real>& e) = 0;
};

/// A derivative, or, of doubles, viscosity.
template <class Real>
std::unique_ptr<LatticeTerm<Real>> make_lattice_term(const LatticeGrid& grid, const Components& components, const Term& term, const std::vector<int>& target);

/// In lattice_viscosity.cpp.
std::unique_ptr<LatticeTerm<double>> make_lattice_viscosity(const LatticeGrid& grid, const Components& components, const Term& term, const std::vector<int>& target);

}    // namespace sphonic
