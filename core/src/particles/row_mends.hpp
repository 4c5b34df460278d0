#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "store.hpp"

namespace sphonic {

/// What is added to a derivative at some particles of a lattice: multiples of the own value, and of others'.
class RowMends {
public:
    using Vector = std::array<double, 3>;
    struct Entry {
        std::ptrdiff_t at;
        double weight[3];
    };

    RowMends(const Layout& layout, bool gradient) : layout_(layout), gradient_(gradient) {}

    /// To the particle at this place in a field, from others at places counted from it; by ascending places.
    void add(std::ptrdiff_t at, const Vector& own, std::span<const Entry> others);
    /// When all are there.
    void close();

    /// Adds to n particles of a row from `offset` on. `f` are the operand's components, `out` the targets.
    template <class Real>
    void mend(std::ptrdiff_t offset, long n, const Real* const* f, Real* const* out, double scale) const {
        mend_own(offset, n, f, out, scale);
        mend_by_others(offset, n, f, out, scale);
    }

private:
    /// Consecutive particles whose own values count along the same axes.
    struct Run {
        std::ptrdiff_t at;
        long n;
        bool along[3];
        std::size_t first;    ///< of their weights, axis by axis
    };
    struct Row {
        std::ptrdiff_t at;
        std::size_t begin, end;    ///< its entries
    };
    Layout layout_;
    bool gradient_;
    std::vector<std::pair<std::ptrdiff_t, Vector>> added_;    ///< own values' weights, until runs are closed
    std::vector<Run> runs_;
    std::vector<double> own_;
    std::vector<Row> rows_;
    std::vector<Entry> entries_;
    std::vector<std::size_t> first_run_, first_row_;    ///< by row of the layout, ghosts among them

    void join_runs();
    std::size_t layout_row(std::ptrdiff_t at) const { return layout_.dimension > 1 ? std::size_t(at / layout_.stride[1]) : 0; }
    template <class Part>
    std::vector<std::size_t> by_layout_row(const std::vector<Part>& parts) const;
    template <class Real>
    void mend_own(std::ptrdiff_t offset, long n, const Real* const* f, Real* const* out, double scale) const;
    template <class Real>
    void mend_by_others(std::ptrdiff_t offset, long n, const Real* const* f, Real* const* out, double scale) const;
};

}    // namespace sphonic
