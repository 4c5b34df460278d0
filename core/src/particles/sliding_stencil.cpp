#include "sliding_stencil.hpp"

#include <algorithm>
#include <cmath>

namespace sphonic {

namespace {

constexpr double near_caches = 8e6;    ///< [bytes]; in less, fetching ahead costs more than it saves

/// True if reversing x turns the sign of d/dx and of nothing else.
bool symmetric(const std::vector<Offset>& stencil, double round_off) {
    return std::ranges::all_of(stencil, [&](const Offset& n) {
        const auto mirror = std::ranges::find_if(stencil, [&](const Offset& m) { return m.o[0] == -n.o[0] && m.o[1] == n.o[1] && m.o[2] == n.o[2]; });
        if (mirror == stencil.end()) return false;
        for (int a = 0; a < 3; ++a)
            if (std::abs(n.gradient[a] - (a == 0 ? -1 : 1) * mirror->gradient[a]) > round_off) return false;
        return true;
    });
}

}    // namespace

template <class Real>
typename SlidingStencil<Real>::Row& SlidingStencil<Real>::row(std::vector<Row>& rows, int component, std::ptrdiff_t at) {
    const auto known = std::ranges::find_if(rows, [&](const Row& r) { return r.component == component && r.at == at; });
    return known != rows.end() ? *known : rows.emplace_back(Row{component, at});
}

template <class Real>
SlidingStencil<Real>::SlidingStencil(const Layout& layout, const std::vector<Offset>& stencil, double factor, bool gradient)
    : components(gradient ? 1 : layout.dimension), far(double(layout.size) * (1 + layout.dimension) * sizeof(Real) > near_caches), next(layout.stride[1]), next_own(layout.stride[1]) {
    int farthest = 0;
    double largest = 0;
    for (const Offset& n : stencil) {
        farthest = std::max(farthest, n.o[0]);
        next = std::max(next, n.o[1] * layout.stride[1] + n.o[2] * layout.stride[2] + layout.stride[1]);
        for (const double g : n.gradient) largest = std::max(largest, std::abs(g));
    }
    const double round_off = 1e-14 * largest;
    if (layout.dimension < 2 || farthest > most_reach || !symmetric(stencil, round_off)) return;
    reach = farthest;
    for (const Offset& n : stencil) {
        const std::ptrdiff_t rho = n.o[1] * layout.stride[1] + n.o[2] * layout.stride[2];
        if (n.o[0] < 0 || rho < 0) continue;    // their mirror images are there
        for (int a = 0; a < layout.dimension; ++a) {
            if (std::abs(n.gradient[a]) <= round_off) continue;
            const Real weight = Real(factor * n.gradient[a]);
            Row& r = row(gradient ? both : a == 0 ? sums : differences, gradient ? 0 : a, rho);
            if (a == 0)
                r.odd[n.o[0] - 1] = rho == 0 ? weight / 2 : weight;    // the own row meets itself
            else
                r.even[gradient ? a - 1 : 0][n.o[0]] = weight;
        }
    }
}

template struct SlidingStencil<double>;
template struct SlidingStencil<float>;

}    // namespace sphonic
