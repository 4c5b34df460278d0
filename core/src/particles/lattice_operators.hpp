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
    /// Sites whose neighbour at `n` exists along an axis: [first, last).
    std::pair<long, long> reachable(const Offset& n, int axis) const {
        if (axis >= layout.dimension) return {0, 1};
        const long count = layout.count[axis];
        if (scene.box.periodic[axis]) return {0, count};
        return {std::max(0L, long(-n.o[axis])), std::min(count, count - n.o[axis])};
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
