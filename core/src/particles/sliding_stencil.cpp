#include "sliding_stencil.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace sphonic {

namespace {

constexpr double near_caches = 8e6;    ///< [bytes]; in less, fetching ahead costs more than it saves

/// True if reversing an axis turns the sign of the derivative along it and of no other.
bool symmetric(const std::vector<Offset>& stencil, int axis, double round_off) {
    return std::ranges::all_of(stencil, [&](const Offset& n) {
        const auto mirrors = [&](const Offset& m) {
            for (int a = 0; a < 3; ++a)
                if (m.o[a] != (a == axis ? -1 : 1) * n.o[a]) return false;
            return true;
        };
        const auto mirror = std::ranges::find_if(stencil, mirrors);
        if (mirror == stencil.end()) return false;
        for (int a = 0; a < 3; ++a)
            if (std::abs(n.gradient[a] - (a == axis ? -1 : 1) * mirror->gradient[a]) > round_off) return false;
        return true;
    });
}

}    // namespace

template <class Real>
SlidingStencil<Real>::SlidingStencil(const Layout& layout, const std::vector<Offset>& stencil, double factor, bool gradient)
    : components(gradient ? 1 : layout.dimension), far(double(layout.size) * (1 + layout.dimension) * sizeof(Real) > near_caches), next(layout.stride[1]), next_own(layout.stride[1]) {
    std::map<std::pair<int, int>, int> farthest;    // by rows (y, z)
    double largest = 0;
    for (const Offset& n : stencil) {
        reach = std::max(reach, n.o[0]);
        farthest[{n.o[1], n.o[2]}] = std::max(farthest[{n.o[1], n.o[2]}], n.o[0]);
        next = std::max(next, n.o[1] * layout.stride[1] + n.o[2] * layout.stride[2] + layout.stride[1]);
        for (const double g : n.gradient) largest = std::max(largest, std::abs(g));
    }
    const double round_off = 1e-14 * largest;
    bool slides = layout.dimension > 1 && reach <= most_reach;
    for (int axis = 0; slides && axis < layout.dimension; ++axis) slides = symmetric(stencil, axis, round_off);
    if (!slides) {
        reach = 0;
        return;
    }
    for (const auto& [place, far_along] : farthest) {
        const auto [y, z] = place;
        if (y < 0 || z < 0) continue;    // their mirror images are there
        Rows r{y * layout.stride[1], z * layout.stride[2]};
        for (const Offset& n : stencil) {
            if (n.o[0] < 0 || n.o[1] != y || n.o[2] != z) continue;
            if (n.o[0] > 0) r.odd[n.o[0] - 1] = Real(factor * n.gradient[0]);
            for (int a = 1; a < layout.dimension; ++a) r.even[a - 1][n.o[0]] = Real(factor * n.gradient[a]);
        }
        const Beside beside = y && z ? Beside::both : y ? Beside::y : z ? Beside::z : Beside::none;
        rows[int(beside)][std::size_t(far_along)].push_back(r);
    }
}

template struct SlidingStencil<double>;
template struct SlidingStencil<float>;

}    // namespace sphonic
