#pragma once
#include <array>
#include <memory>
#include <vector>

#include <sphonic/case.hpp>

#include "parallel.hpp"
#include "particle_media.hpp"
#include "stencil.hpp"
#include "store.hpp"
#include "tier.hpp"

namespace sphonic {

/// What all operators of one lattice share.
struct LatticeGrid {
    LatticeGrid(const Case& scene, const ParticleMedia& media, long reach);

    const Case& scene;
    const ParticleMedia& media;
    Layout layout;
    int threads;
    std::vector<std::vector<Offset>> neighbours{};    ///< by kernel

    int medium(const std::array<long, 3>& site) const {
        return media.number(site[0] + layout.count[0] * (site[1] + layout.count[1] * site[2]));
    }
    /// Calls block(medium, offset in the field, particles) for consecutive particles of one medium, over all rows.
    template <class Block>
    void for_blocks(Block block) const {
        if (!media.several()) return in_row_blocks(threads, layout, [&](long, long offset, long, long n) { block(0, offset, n); });
        in_parallel(threads, long(stretches_.size()), [&](long i) {
            const Stretch& s = stretches_[std::size_t(i)];
            block(s.medium, s.offset, s.n);
        });
    }

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
    std::vector<Stretch> stretches_;    ///< where there are several media
};

/// One term of one variable on a lattice.
class LatticeOperator {
public:
    virtual ~LatticeOperator() = default;
    virtual void apply(const Evaluation& e) = 0;
};

std::unique_ptr<LatticeOperator> make_lattice_operator(const LatticeGrid& grid, const Components& components,
                                                       const Term& term, const std::vector<int>& target);

/// In lattice_viscosity.cpp.
std::unique_ptr<LatticeOperator> make_lattice_viscosity(const LatticeGrid& grid, const Components& components,
                                                        const Term& term, const std::vector<int>& target);

}    // namespace sphonic
