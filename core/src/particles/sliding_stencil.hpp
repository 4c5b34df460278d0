#pragma once
#include <array>
#include <vector>

#include "stencil.hpp"
#include "store.hpp"

namespace sphonic {

/// An antisymmetric stencil with the symmetry of its lattice as sums along x of sums across it. Reversing y turns the sign of d/dy
/// alone, so rows meet as S = sum f(+-y, +-z), as Y = f(y, .) - f(-y, .) summed over +-z, and as Z likewise:
///   df/dx = sum_s A_s(i + s) - A_s(i - s),   df/dy = B_0(i) + sum_s B_s(i + s) + B_s(i - s),
///   A_s = sum_(y,z >= 0) w_x(s, y, z) S,   B_s = sum_(y,z >= 0) w_y(s, y, z) Y,   and with Z for df/dz.
template <class Real>
struct SlidingStencil {
    static constexpr int most_reach = 3;    ///< beyond, the columns of two vectors would not stay in registers

    /// What is beside the own row: both rows at +-y, both at +-z, or all four at +-y, +-z.
    enum class Beside { none, y, z, both };
    /// Rows at the same distance, and the weights of what they sum up to in A_1 ... and, for y and z, in B_0 ...
    struct Rows {
        std::ptrdiff_t y, z;
        Real odd[most_reach] = {}, even[2][most_reach + 1] = {};
    };
    /// Of rows of one kind that reach s particles along x: those that reach less cost less.
    std::array<std::vector<Rows>, most_reach + 1> rows[4];

    int reach = 0;                 ///< 0 where the stencil lacks that symmetry or reaches too far
    int components;                ///< that are read
    bool far;                      ///< the fields are more than near caches hold
    std::ptrdiff_t next, next_own; ///< from a particle to what those of the next row are the first to read, and to their own places

    /// A gradient reads one component, a divergence as many as there are dimensions.
    SlidingStencil(const Layout& layout, const std::vector<Offset>& stencil, double factor, bool gradient);
};

}    // namespace sphonic
