#pragma once
#include <map>
#include <optional>

#include "correction.hpp"
#include "lattice_operators.hpp"

namespace sphonic {

/// What a derivative's stencil leaves wrong: near the open ends of a lattice, where neighbours are missing, the own value's
/// weights do not cancel, and a correction is another one; near another medium the form weighs the values otherwise.
class MendedRows {
public:
    /// `stencils` are the interior's weights by medium.
    MendedRows(const LatticeGrid& grid, const Term& term, const std::vector<std::vector<Offset>>& stencils);

    /// Adds what is missing to n particles of a row from `offset` on. `f` are the operand's components, `out` the targets.
    template <class Real>
    void mend(std::ptrdiff_t offset, long n, const Real* const* f, Real* const* out, double scale) const;

private:
    using Vector = std::array<double, 3>;
    using Matrix = std::array<double, 9>;
    using Site = std::array<long, 3>;
    struct Row {
        std::ptrdiff_t at;
        double own[3];
        std::size_t begin, end;    ///< its entries
    };
    struct Entry {
        std::ptrdiff_t at;
        double weight[3];
    };
    const LatticeGrid& grid_;
    const Term& term_;
    const std::vector<std::vector<Offset>>& stencils_;    ///< while rows are added
    std::vector<std::uint8_t> medium_;                    ///< of sites and ghosts, where the form tells media apart
    std::vector<RestCoefficients> between_;               ///< [own medium][other's]
    std::vector<Row> rows_;
    std::vector<std::size_t> first_;                      ///< of them, by row of the layout, ghosts among them
    std::vector<Entry> entries_;
    std::map<Site, Matrix> corrections_;

    void find_media();
    bool near_end(int axis, long i) const;
    bool meets_another(const Site& site) const;
    void add_rows();
    void add_row(const Site& site, bool end);
    std::pair<Vector, Vector> weights(const Site& site, const Site& other, std::size_t k, bool end);
    long image(int axis, long i) const;
    std::optional<Site> neighbour(const Site& site, const Offset& n) const;
    const Matrix& correction(const Site& site);
    void index_rows();
    std::size_t layout_row(std::ptrdiff_t at) const { return grid_.layout.dimension > 1 ? std::size_t(at / grid_.layout.stride[1]) : 0; }
    std::ptrdiff_t at(const Site& site) const { return grid_.layout.at(site[0], site[1], site[2]); }
    int medium(const Site& site) const { return medium_.empty() ? grid_.medium(site) : medium_[std::size_t(at(site))]; }
    const RestCoefficients& between(int i, int j) const { return between_[std::size_t(i * grid_.media.count() + j)]; }
};

}    // namespace sphonic
