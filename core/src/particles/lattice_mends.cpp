#include "lattice_mends.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include <sphonic/error.hpp>

#include "correction.hpp"

namespace sphonic {
namespace {

std::array<double, 3> product(const std::array<double, 9>& L, const double* g, double factor) {
    std::array<double, 3> v{};
    for (std::size_t a = 0; a < 3; ++a) v[a] = factor * (L[3 * a] * g[0] + L[3 * a + 1] * g[1] + L[3 * a + 2] * g[2]);
    return v;
}

/// Finds what a stencil leaves wrong.
class MendedRows {
public:
    MendedRows(const LatticeGrid& grid, const Term& term, const std::vector<std::vector<Offset>>& stencils);

    RowMends mends() && { return std::move(mends_); }

private:
    using Vector = RowMends::Vector;
    using Matrix = std::array<double, 9>;
    using Site = std::array<long, 3>;
    struct Mend {
        Vector own{};
        std::vector<RowMends::Entry> others{};    ///< at their strides from the particle
    };
    const LatticeGrid& grid_;
    const Term& term_;
    const std::vector<std::vector<Offset>>& stencils_;
    std::vector<std::uint8_t> medium_;                    ///< of sites and ghosts, where the form tells media apart
    std::vector<RestCoefficients> between_;               ///< [own medium][other's]
    std::map<Site, Matrix> corrections_;
    std::map<Site, Mend> known_;                          ///< in one medium: by place among the ends
    RowMends mends_;

    void find_media();
    bool near_end(int axis, long i) const;
    Site among_ends(const Site& site) const;
    bool meets_another(const Site& site) const;
    void add_rows();
    void add(const Site& site, bool end);
    Mend mend_of(const Site& site, bool end);
    std::pair<Vector, Vector> weights(const Site& site, const Site& other, std::size_t k, bool end);
    /// Of what an end changes [sites].
    long depth(int axis) const { return (term_.form->correction() == abi::Correction::pairwise ? 2 : 1) * grid_.layout.ghosts[axis]; }
    long image(int axis, long i) const;
    std::optional<Site> neighbour(const Site& site, const Offset& n) const;
    const Matrix& correction(const Site& site);
    std::ptrdiff_t at(const Site& site) const { return grid_.layout.at(site[0], site[1], site[2]); }
    int medium(const Site& site) const { return medium_.empty() ? grid_.medium(site) : medium_[std::size_t(at(site))]; }
    const RestCoefficients& between(int i, int j) const { return between_[std::size_t(i * grid_.media.count() + j)]; }
};

MendedRows::MendedRows(const LatticeGrid& grid, const Term& term, const std::vector<std::vector<Offset>>& stencils)
    : grid_(grid), term_(term), stencils_(stencils), mends_(grid.layout, term.op == Term::Operator::gradient) {
    for (const abi::Medium& i : grid.media.list())
        for (const abi::Medium& j : grid.media.list()) between_.push_back(rest_coefficients(*term.form, derivative(term), i, j));
    if (grid.media.several() && !term.form->uniform()) find_media();
    add_rows();
    mends_.close();
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
    const long within = depth(axis);
    return (grid_.open(axis, false) && i < within) || (grid_.open(axis, true) && i >= l.count[axis] - within);
}

/// The same for particles with the same neighbourhood: where one is within reach of an end, and one number for all the others.
MendedRows::Site MendedRows::among_ends(const Site& site) const {
    Site place{-1, -1, -1};
    for (int a = 0; a < grid_.layout.dimension; ++a)
        if (near_end(a, site[std::size_t(a)])) place[std::size_t(a)] = site[std::size_t(a)];
    return place;
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
                if (end || (!medium_.empty() && meets_another({i, j, k}))) add({i, j, k}, end);
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

void MendedRows::add(const Site& site, bool end) {
    if (grid_.media.several()) {
        const Mend mend = mend_of(site, end);
        return mends_.add(at(site), mend.own, mend.others);
    }
    const auto [known, fresh] = known_.try_emplace(among_ends(site));
    if (fresh) known->second = mend_of(site, end);
    mends_.add(at(site), known->second.own, known->second.others);
}

/// Where the weights are means of two media's, they do not add up to nothing, and of gradient and divergence only one could
/// take differences if energy is to be conserved. Each takes what the impedances make of it: the one that hurts less more.
MendedRows::Mend MendedRows::mend_of(const Site& site, bool end) {
    const int m = medium(site);
    const auto& stencil = stencils_[std::size_t(m)];
    const double coefficient = term_.coefficient[std::size_t(m)];
    Vector rest{};                           // sum of the weights
    double crossing = 0, share = 0;          // pairs between two media, and what they take of it
    Mend mend;
    for (std::size_t k = 0; k < stencil.size(); ++k) {
        const auto other = neighbour(site, stencil[k]);
        if (!other) continue;
        const RestCoefficients c = between(m, medium(*other));
        const auto [own, theirs] = weights(site, *other, k, end);
        RowMends::Entry entry{.at = grid_.stride(stencil[k]), .weight = {0, 0, 0}};
        for (std::size_t a = 0; a < 3; ++a) {
            mend.own[a] += coefficient * c.own * own[a];
            rest[a] += own[a];
            entry.weight[a] = coefficient * (c.other * theirs[a] - between(m, m).other * stencil[k].gradient[a]);
        }
        if (std::ranges::any_of(entry.weight, [](double w) { return w != 0; })) mend.others.push_back(entry);
        if (medium(*other) == m) continue;
        share += c.other;
        ++crossing;
    }
    for (std::size_t a = 0; a < 3 && crossing > 0 && !term_.fitted.empty(); ++a) mend.own[a] += coefficient * share / crossing * rest[a];
    return mend;
}

}    // namespace

RowMends lattice_mends(const LatticeGrid& grid, const Term& term, const std::vector<std::vector<Offset>>& stencils) {
    return MendedRows(grid, term, stencils).mends();
}

}    // namespace sphonic
