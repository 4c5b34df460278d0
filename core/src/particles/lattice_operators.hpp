#pragma once
#include <memory>
#include <vector>

#include <sphonic/case.hpp>

#include "stencil.hpp"
#include "store.hpp"
#include "tier.hpp"

namespace sphonic {

/// What all operators of one lattice share.
struct LatticeGrid {
    const Case& scene;
    Layout layout;
    int threads;
    std::vector<std::vector<Offset>> neighbours{};    ///< by kernel

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
