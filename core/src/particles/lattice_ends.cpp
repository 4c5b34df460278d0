#include "lattice_ends.hpp"

#include <algorithm>
#include <string>

#include <sphonic/error.hpp>

namespace sphonic {
namespace {

void add_product(const std::array<double, 9>& L, const double* g, double factor, double* sum) {
    for (std::size_t a = 0; a < 3; ++a) sum[a] += factor * (L[3 * a] * g[0] + L[3 * a + 1] * g[1] + L[3 * a + 2] * g[2]);
}

}    // namespace

EndRows::EndRows(const LatticeGrid& grid, const Term& term, double own, double other, const std::vector<Offset>& stencil)
    : grid_(grid), term_(term), own_(own), other_(other) {
    const Layout& l = grid.layout;
    const long reach = term.form->correction() == abi::Correction::pairwise ? 2 : 1;    // of what an end changes, in supports
    const auto near_end = [&](int axis, long i) {
        if (axis >= l.dimension) return false;
        const long within = reach * l.ghosts[axis];
        return (grid.open(axis, false) && i < within) || (grid.open(axis, true) && i >= l.count[axis] - within);
    };
    for (long k = 0; k < l.count[2]; ++k)
        for (long j = 0; j < l.count[1]; ++j) {
            const bool whole_row = near_end(1, j) || near_end(2, k);
            for (long i = 0; i < l.count[0]; ++i) {
                if (!whole_row && !near_end(0, i))
                    i = std::max(i, l.count[0] - reach * l.ghosts[0] - 1);    // skip the interior
                else
                    add_row({i, j, k}, stencil);
            }
        }
    corrections_.clear();
}

/// The particle whose neighbourhood a ghost shares.
long EndRows::image(int axis, long i) const {
    const long count = grid_.layout.count[axis];
    if (grid_.scene.box.periodic[axis]) return ((i % count) + count) % count;
    if (i < 0) return std::min(count - 1, -i);
    return i < count ? i : std::max(0L, 2 * (count - 1) - i);
}

std::optional<EndRows::Site> EndRows::neighbour(const Site& site, const Offset& n) const {
    Site at = site;
    for (int a = 0; a < grid_.layout.dimension; ++a) {
        const long count = grid_.layout.count[a];
        long& i = at[std::size_t(a)];
        i += n.o[a];
        if (i < 0 && grid_.open(a, false)) return std::nullopt;
        if (i >= count && grid_.open(a, true)) return std::nullopt;
        i = image(a, i);
    }
    return at;
}

const EndRows::Matrix& EndRows::correction(const Site& site) {
    if (const auto known = corrections_.find(site); known != corrections_.end()) return known->second;
    static constexpr Matrix identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
    if (term_.form->correction() == abi::Correction::none) return identity;
    const auto& neighbours = grid_.neighbours[std::size_t(term_.kernel)];
    const double dx = grid_.scene.box.dx, volume = lattice_volume(grid_.scene.box);
    Moment moment(grid_.layout.dimension);
    long count = 0;
    for (const Offset& n : neighbours) {
        if (!neighbour(site, n)) continue;
        const double r[3] = {-n.o[0] * dx, -n.o[1] * dx, -n.o[2] * dx};
        moment.add(r, volume * n.slope);
        ++count;
    }
    const auto inverse = moment.inverse();
    if (!inverse) {
        std::string at;
        for (int a = 0; a < grid_.layout.dimension; ++a)
            at += (a ? ", " : "") + std::to_string(grid_.scene.box.lower[a] + double(site[std::size_t(a)]) * dx);
        throw Error(Fault::input, grid_.scene.file + ": /kernel", "the " + std::to_string(count) + " neighbours of the particle at (" + at +
                    ") m do not determine a gradient, which a corrected form needs", "Choose a larger h, or close the box with boundaries");
    }
    return corrections_.emplace(site, *inverse).first->second;
}

void EndRows::add_row(const Site& site, const std::vector<Offset>& stencil) {
    const auto& neighbours = grid_.neighbours[std::size_t(term_.kernel)];
    const abi::Correction kind = term_.form->correction();
    const double volume = lattice_volume(grid_.scene.box);
    const Matrix L = correction(site);
    Row row{.at = grid_.layout.at(site[0], site[1], site[2]), .own = {0, 0, 0}, .end = 0};
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
        const auto other = neighbour(site, neighbours[k]);
        if (!other) continue;
        add_product(L, neighbours[k].gradient, own_ * volume, row.own);
        if (kind == abi::Correction::none) continue;
        Entry entry{.at = row.at + grid_.stride(neighbours[k]), .weight = {0, 0, 0}};
        add_product(kind == abi::Correction::own ? L : correction(*other), neighbours[k].gradient, other_ * volume, entry.weight);
        for (int a = 0; a < 3; ++a) entry.weight[a] -= other_ * stencil[k].gradient[a];
        entries_.push_back(entry);
    }
    row.end = entries_.size();
    rows_.push_back(row);
}

void EndRows::mend(const double* const* f, double* const* out, double scale) const {
    const int d = grid_.layout.dimension;
    const bool gradient = term_.op == Term::Operator::gradient;
    const Entry* entry = entries_.data();
    for (const Row& row : rows_) {
        double sum[3] = {0, 0, 0};
        for (int a = 0; a < d; ++a) sum[a] = row.own[a] * f[gradient ? 0 : a][row.at];
        for (; entry != entries_.data() + row.end; ++entry)
            for (int a = 0; a < d; ++a) sum[a] += entry->weight[a] * f[gradient ? 0 : a][entry->at];
        for (int a = 0; a < d; ++a) out[gradient ? a : 0][row.at] += scale * sum[a];
    }
}

}    // namespace sphonic
