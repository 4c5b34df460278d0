#pragma once
#include <vector>

#include "stencil.hpp"
#include "store.hpp"

namespace sphonic {

/// An antisymmetric stencil, w(-o) = -w(o), as sums along x of sums across it. With s >= 0 along a row and rho across it, rows meet
/// as f(rho) + f(-rho), whose weights are odd in s, and as f(rho) - f(-rho), whose weights are even:
///   sum_o w(o) f(i + o) = sum_s [ A_s(i + s) - A_s(i - s) + B_s(i + s) + B_s(i - s) ],
///   A_s = sum_rho w(s, rho) (f(rho) + f(-rho)),   B_s = sum_rho w(s, rho) (f(rho) - f(-rho)),
/// over one of each pair rho, -rho. Symmetry leaves only the A_s of d/dx and only the B_s of d/dy and d/dz.
template <class Real>
struct SlidingStencil {
    static constexpr int most_reach = 3;    ///< beyond, the columns of three vectors would not stay in registers

    /// Two rows beside a particle's: weights in A_1 ... and, by set of columns, in B_0 ...
    struct Row {
        int component;
        std::ptrdiff_t at;
        Real odd[most_reach] = {}, even[2][most_reach + 1] = {};
    };
    int reach = 0;    ///< 0 where the stencil lacks that symmetry or reaches too far
    std::vector<Row> sums, differences, both;
    int components;                ///< that are read
    bool far;                      ///< the fields are more than near caches hold
    std::ptrdiff_t next, next_own; ///< from a particle to what those of the next row are the first to read, and to their own places

    /// A gradient has one component and a set of columns B for each of d/dy, d/dz; a divergence d components and one set.
    SlidingStencil(const Layout& layout, const std::vector<Offset>& stencil, double factor, bool gradient);

private:
    static Row& row(std::vector<Row>& rows, int component, std::ptrdiff_t at);
};

}    // namespace sphonic
