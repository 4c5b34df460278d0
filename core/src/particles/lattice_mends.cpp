#include "lattice_mends.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include <sphonic/error.hpp>

namespace sphonic {
namespace {

std::array<double, 3> product(const std::array<double, 9>& L, const double* g, double factor) {
    std::array<double, 3> v{};
    for (std::size_t a = 0; a < 3; ++a) v[a] = factor * (L[3 * a] * g[0] + L[3 * a + 1] * g[1] + L[3 * a + 2] * g[2]);
    return v;
}

}    // namespace

MendedRows::MendedRows(const LatticeGrid& grid, const Term& term, const std::vector<std::vector<Offset>>& stencils)
    : grid_(grid), term_(term), stencils_(stencils) {
    for (const abi::Medium& i : grid.media.list())
        for (const abi::Medium& j : grid.media.list()) between_.push_back(rest_coefficients(*term.form, derivative(term), i, j));
    if (grid.media.several() && !term.form->uniform()) find_media();
    add_rows();
    index_rows();
    corrections_.clear();
    medium_ = {};
}

/// Ghosts are of their image's medium.
void MendedRows::find_media() {
    const Layout& l = grid_.layout;
    medium_.resize(std::size_t(l.size));
    for (long k = -l.ghosts[2]; k < l.count[2] + l.ghosts[2]; ++k)
        for (long j = -l.ghosts[1]; j < l.count[1] + l.ghosts[1]; ++j)
            for (long i = -l.ghosts[0]; i < l.count[0] + l.ghosts[0]; ++i)
                medium_[std::size_t(l.at(i, j, k))] = std::uint8_t(grid_.medium({image(0, i), image(1, j), image(2, k)}));
}

bool MendedRows::near_end(int axis, long i) const {
    const Layout& l = grid_.layout;
    if (axis >= l.dimension) return false;
    const long supports = term_.form->correction() == abi::Correction::pairwise ? 2 : 1;    // that an end changes
    const long within = supports * l.ghosts[axis];
    return (grid_.open(axis, false) && i < within) || (grid_.open(axis, true) && i >= l.count[axis] - within);
}

bool MendedRows::meets_another(const Site& site) const {
    const std::uint8_t* here = medium_.data() + at(site);
    return std::ranges::any_of(stencils_[*here], [&](const Offset& n) { return here[grid_.stride(n)] != *here; });
}

void MendedRows::add_rows() {
    const Layout& l = grid_.layout;
    for (long k = 0; k < l.count[2]; ++k)
        for (long j = 0; j < l.count[1]; ++j) {
            const bool whole_row = near_end(1, j) || near_end(2, k);
            for (long i = 0; i < l.count[0]; ++i) {
                const bool end = whole_row || near_end(0, i);
                if (end || (!medium_.empty() && meets_another({i, j, k}))) add_row({i, j, k}, end);
            }
        }
}

/// The particle whose neighbourhood a ghost shares.
long MendedRows::image(int axis, long i) const {
    const long count = grid_.layout.count[axis];
    if (i >= 0 && i < count) return i;
    if (grid_.scene.box.periodic[axis]) return ((i % count) + count) % count;
    const abi::Boundary* wall = grid_.scene.face(axis, i >= count);
    const long own = wall && wall->half_way() ? 1 : 0;    // the last particle is its own image's neighbour
    return std::clamp(i < 0 ? -i - own : 2 * (count - 1) + own - i, 0L, count - 1);
}

std::optional<MendedRows::Site> MendedRows::neighbour(const Site& site, const Offset& n) const {
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

const MendedRows::Matrix& MendedRows::correction(const Site& site) {
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

/// The k-th pair's weights of the own and of the other's value, before the form's coefficients. At an end the neighbourhood has
/// a correction of its own; elsewhere it is the stencil's. Where two media's stencils differ, the pair has their mean: with
/// other weights for i and j no energy is conserved.
std::pair<MendedRows::Vector, MendedRows::Vector> MendedRows::weights(const Site& site, const Site& other, std::size_t k, bool end) {
    const auto& stencil = stencils_[std::size_t(medium(site))];
    const auto& others = stencils_[std::size_t(medium(other))];
    const abi::Correction kind = term_.form->correction();
    if (end && kind != abi::Correction::none) {
        const double volume = lattice_volume(grid_.scene.box);
        const double* gradient = grid_.neighbours[std::size_t(term_.kernel)][k].gradient;
        return {product(correction(site), gradient, volume), product(correction(kind == abi::Correction::own ? site : other), gradient, volume)};
    }
    Vector mean{};
    for (std::size_t a = 0; a < 3; ++a) mean[a] = 0.5 * (stencil[k].gradient[a] + others[k].gradient[a]);
    return {mean, mean};
}

/// Where the weights are means of two media's, they do not add up to nothing, and of gradient and divergence only one could
/// take differences if energy is to be conserved. Each takes what the impedances make of it: the one that hurts less more.
void MendedRows::add_row(const Site& site, bool end) {
    const int m = medium(site);
    const auto& stencil = stencils_[std::size_t(m)];
    const double coefficient = term_.coefficient[std::size_t(m)];
    Vector rest{};                           // sum of the weights
    double crossing = 0, share = 0;          // pairs between two media, and what they take of it
    Row row{.at = at(site), .own = {0, 0, 0}, .begin = entries_.size(), .end = 0};
    for (std::size_t k = 0; k < stencil.size(); ++k) {
        const auto other = neighbour(site, stencil[k]);
        if (!other) continue;
        const RestCoefficients c = between(m, medium(*other));
        const auto [own, theirs] = weights(site, *other, k, end);
        Entry entry{.at = row.at + grid_.stride(stencil[k]), .weight = {0, 0, 0}};
        for (std::size_t a = 0; a < 3; ++a) {
            row.own[a] += coefficient * c.own * own[a];
            rest[a] += own[a];
            entry.weight[a] = coefficient * (c.other * theirs[a] - between(m, m).other * stencil[k].gradient[a]);
        }
        if (std::ranges::any_of(entry.weight, [](double w) { return w != 0; })) entries_.push_back(entry);
        if (medium(*other) == m) continue;
        share += c.other;
        ++crossing;
    }
    for (std::size_t a = 0; a < 3 && crossing > 0 && !term_.fitted.empty(); ++a) row.own[a] += coefficient * share / crossing * rest[a];
    row.end = entries_.size();
    rows_.push_back(row);
}

void MendedRows::index_rows() {
    first_.assign(layout_row(grid_.layout.size) + 2, 0);
    for (const Row& row : rows_) ++first_[layout_row(row.at) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

template <class Real>
void MendedRows::mend(std::ptrdiff_t offset, long n, const Real* const* f, Real* const* out, double scale) const {
    const std::size_t here = layout_row(offset);
    const Row *first = rows_.data() + first_[here], *last = rows_.data() + first_[here + 1];
    if (first == last) return;
    const int d = grid_.layout.dimension;
    const bool gradient = term_.op == Term::Operator::gradient;
    for (const Row* row = std::lower_bound(first, last, offset, [](const Row& r, std::ptrdiff_t at) { return r.at < at; }); row != last && row->at < offset + n; ++row) {
        double sum[3] = {0, 0, 0};
        for (int a = 0; a < d; ++a) sum[a] = row->own[a] * f[gradient ? 0 : a][row->at];
        for (const Entry* entry = entries_.data() + row->begin; entry != entries_.data() + row->end; ++entry)
            for (int a = 0; a < d; ++a) sum[a] += entry->weight[a] * f[gradient ? 0 : a][entry->at];
        for (int a = 0; a < d; ++a) out[gradient ? a : 0][row->at] += Real(scale * sum[a]);
    }
}

template void MendedRows::mend<double>(std::ptrdiff_t, long, const double* const*, double* const*, double) const;
template void MendedRows::mend<float>(std::ptrdiff_t, long, const float* const*, float* const*, double) const;

}    // namespace sphonic
