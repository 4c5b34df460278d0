#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <sphonic/plugin/abi/arrangement.hpp>

namespace sphonic {

/// Particles sorted into cubic cells at least `side` wide.
class Cells {
public:
    Cells(const abi::Box& box, long n, const double* const* x, double side) : d_(box.dimension) {
        for (int a = 0; a < d_; ++a) {
            periodic_[a] = box.periodic[a];
            const auto [least, most] = std::minmax_element(x[a], x[a] + n);
            lower_[a] = periodic_[a] ? box.lower[a] : *least;
            const double length = periodic_[a] ? box.upper[a] - box.lower[a] : *most - *least;
            const double limit = std::pow(4.0 * double(n) + 64, 1.0 / d_);    // no more cells than a few per particle
            count_[a] = std::max(1L, long(std::min(length / side, limit)));
            width_[a] = std::max(length / double(count_[a]), side * 1e-12);
        }
        first_.assign(std::size_t(count_[0] * count_[1] * count_[2] + 1), 0);
        cell_.resize(std::size_t(n));
        for (long i = 0; i < n; ++i) {
            cell_[std::size_t(i)] = index(of(x, i));
            ++first_[std::size_t(cell_[std::size_t(i)] + 1)];
        }
        for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
        member_.resize(std::size_t(n));
        std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
        for (long i = 0; i < n; ++i) member_[std::size_t(next[std::size_t(cell_[std::size_t(i)])]++)] = std::int32_t(i);
    }

    std::array<long, 3> of(const double* const* x, long i) const {
        std::array<long, 3> c{};
        for (int a = 0; a < d_; ++a) {
            const long k = long(std::floor((x[a][i] - lower_[a]) / width_[a]));
            c[std::size_t(a)] = periodic_[a] ? ((k % count_[a]) + count_[a]) % count_[a] : std::clamp(k, 0L, count_[a] - 1);
        }
        return c;
    }

    /// Places of particles in and around the cell of one, as few spans in a fixed order.
    void around(std::int32_t i, std::vector<std::pair<long, long>>& spans) const {
        std::vector<long> cells;
        const auto c = site(cell_[std::size_t(i)]);
        std::array<long, 3> low{}, high{};
        for (std::size_t a = 0; a < std::size_t(d_); ++a) low[a] = -1, high[a] = 1;
        for (long dz = low[2]; dz <= high[2]; ++dz)
            for (long dy = low[1]; dy <= high[1]; ++dy)
                for (long dx = low[0]; dx <= high[0]; ++dx) {
                    std::array<long, 3> at{c[0] + dx, c[1] + dy, c[2] + dz};
                    if (wrap(at)) cells.push_back(index(at));
                }
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        spans.clear();
        for (const long cell : cells) {
            const long begin = first_[std::size_t(cell)], end = first_[std::size_t(cell) + 1];
            if (!spans.empty() && spans.back().second == begin)
                spans.back().second = end;
            else
                spans.emplace_back(begin, end);
        }
    }

    /// Particles by place: cell by cell, ascending in each.
    const std::vector<std::int32_t>& members() const { return member_; }
    long cell(std::int32_t i) const { return cell_[std::size_t(i)]; }

private:
    int d_;
    bool periodic_[3] = {};
    double lower_[3] = {}, width_[3] = {1, 1, 1};
    long count_[3] = {1, 1, 1};
    std::vector<std::int32_t> first_, member_;
    std::vector<long> cell_;

    long index(const std::array<long, 3>& c) const { return c[0] + count_[0] * (c[1] + count_[1] * c[2]); }
    std::array<long, 3> site(long cell) const { return {cell % count_[0], cell / count_[0] % count_[1], cell / (count_[0] * count_[1])}; }
    /// The cell itself or its periodic image; false if there is none.
    bool wrap(std::array<long, 3>& at) const {
        bool exists = true;
        for (int a = 0; a < d_; ++a) {
            long& v = at[std::size_t(a)];
            if (periodic_[a])
                v = (v + count_[a]) % count_[a];
            else
                exists = exists && v >= 0 && v < count_[a];
        }
        return exists;
    }
};

}    // namespace sphonic
