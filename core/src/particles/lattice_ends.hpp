#pragma once
#include <map>
#include <optional>

#include "correction.hpp"
#include "lattice_operators.hpp"

namespace sphonic {

/// What a derivative's stencil leaves wrong near the open ends of a lattice, where neighbours are missing: the own value's
/// weights do not cancel there, and a correction is another one.
class EndRows {
public:
    /// `own` and `other` are the form's coefficients, times whatever is common to all pairs; `stencil` the interior's weights.
    EndRows(const LatticeGrid& grid, const Term& term, double own, double other, const std::vector<Offset>& stencil);

    /// Adds what is missing. `f` are the operand's components, `out` the targets.
    void mend(const double* const* f, double* const* out, double scale) const;

private:
    using Matrix = std::array<double, 9>;
    using Site = std::array<long, 3>;
    struct Row {
        std::ptrdiff_t at;
        double own[3];
        std::size_t end;    ///< of its entries
    };
    struct Entry {
        std::ptrdiff_t at;
        double weight[3];
    };
    const LatticeGrid& grid_;
    const Term& term_;
    double own_, other_;
    std::vector<Row> rows_;
    std::vector<Entry> entries_;
    std::map<Site, Matrix> corrections_;

    void add_row(const Site& site, const std::vector<Offset>& stencil);
    long image(int axis, long i) const;
    std::optional<Site> neighbour(const Site& site, const Offset& n) const;
    const Matrix& correction(const Site& site);
};

}    // namespace sphonic
