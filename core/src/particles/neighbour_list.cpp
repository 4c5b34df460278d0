#include "neighbour_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "cells.hpp"
#include "lanes.hpp"
#include "parallel.hpp"

namespace sphonic {
namespace {

/// The rows of places that follow each other in a set sorted into cells.
class Rows {
public:
    /// `x` of all particles.
    Rows(const Cells& cells, const NeighbourList& list, const double* const* x, double reach) : cells_(cells), list_(list), reach2_(reach * reach) {
        const auto& member = cells.members();
        for (int a = 0; a < list.dimension(); ++a) {
            x_[a].resize(member.size() + overrun);
            for (std::size_t m = 0; m < member.size(); ++m) x_[a][m] = x[a][member[m]];
        }
        member_ = member;
        member_.resize(member.size() + overrun);
    }

    /// Appends the neighbours of places begin ... end - 1 that belong to particles below `own`, and the length of each one's row.
    void find(long begin, long end, long own, std::vector<std::int32_t>& neighbour, std::vector<std::int64_t>& length) const {
        std::vector<std::pair<long, long>> spans;
        std::size_t found = 0;
        long cell = -1;
        for (long m = begin; m < end; ++m) {
            const std::int32_t i = member_[std::size_t(m)];
            if (i >= own) continue;
            if (std::exchange(cell, cells_.cell(i)) != cells_.cell(i)) cells_.around(i, spans);
            const std::size_t before = found;
            for (const auto& [first, last] : spans) {
                const bool mine = first <= m && m < last;    // which leaves itself out
                const long room = long(found) + last - first;
                if (long(neighbour.size()) < room) neighbour.resize(std::size_t(2 * room));
                found += near(m, first, mine ? m : last, neighbour.data() + found);
                if (mine) found += near(m, m + 1, last, neighbour.data() + found);
            }
            length.push_back(std::int64_t(found - before));
        }
        neighbour.resize(found);
    }

private:
    const Cells& cells_;
    const NeighbourList& list_;
    double reach2_;
    std::vector<double> x_[3];    ///< by place
    std::vector<std::int32_t> member_;

    std::size_t near(long m, long first, long last, std::int32_t* found) const {
        int count = 0;
        for (long k = first; k < last; k += lanes) {
            Lane r2 = {};
            for (int a = 0; a < list_.dimension(); ++a) {
                const Lane r = list_.period(a).nearest(x_[a][std::size_t(m)] - load(x_[a].data() + k));
                r2 += r * r;
            }
            count += keep(r2 < reach2_, int(std::min<long>(lanes, last - k)), member_.data() + k, found + count);
        }
        return std::size_t(count);
    }
};

}    // namespace

NeighbourList::NeighbourList(const abi::Box& box, long particles, double radius, double skin, int threads)
    : box_(box), n_(particles), radius_(radius), skin_(skin), threads_(threads) {
    for (int a = 0; a < box.dimension; ++a)
        if (box.periodic[a]) period_[a] = Period(box.upper[a] - box.lower[a]);
}

bool NeighbourList::moved(const double* const* x) const {
    double worst = 0;
    for (long i = 0; i < n_; ++i) {
        double d2 = 0;
        for (int a = 0; a < box_.dimension; ++a) {
            const double d = x[a][i] - built_at_[a][std::size_t(i)];
            d2 += d * d;
        }
        worst = d2 > worst ? d2 : worst;
    }
    return !(worst <= 0.25 * skin_ * skin_);
}

void NeighbourList::build(const double* const* x, long images) {
    for (int a = 0; a < box_.dimension; ++a) built_at_[a].assign(x[a], x[a] + n_);
    const Cells cells(box_, n_ + images, x, radius_ + skin_);
    const Rows rows(cells, *this, x, radius_ + skin_);
    const long places = n_ + images, pieces = (places + block_length - 1) / block_length;
    std::vector<std::vector<std::int32_t>> neighbour{std::size_t(pieces)};
    std::vector<std::vector<std::int64_t>> length{std::size_t(pieces)};
    in_parallel(threads_, pieces, [&](long k) {
        rows.find(k * block_length, std::min((k + 1) * block_length, places), n_, neighbour[std::size_t(k)], length[std::size_t(k)]);
    });
    start_.assign(1, 0);
    for (const auto& piece : length)
        for (const std::int64_t l : piece) start_.push_back(start_.back() + l);
    order_.clear();
    std::copy_if(cells.members().begin(), cells.members().end(), std::back_inserter(order_), [&](std::int32_t i) { return i < n_; });
    neighbour_.resize(std::size_t(start_.back() + overrun));
    auto to = neighbour_.begin();
    for (const auto& piece : neighbour) to = std::copy(piece.begin(), piece.end(), to);
    std::fill(to, neighbour_.end(), 0);
    if (skin_ == 0) order_by_particle();
}

/// Rows in the order of their particles, each ascending.
void NeighbourList::order_by_particle() {
    std::vector<std::int64_t> start(start_.size(), 0);
    for (std::size_t k = 0; k < order_.size(); ++k) start[std::size_t(order_[k]) + 1] = start_[k + 1] - start_[k];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::int32_t> neighbour(neighbour_.size(), 0);
    for (std::size_t k = 0; k < order_.size(); ++k) {
        const auto to = neighbour.begin() + start[std::size_t(order_[k])];
        std::sort(to, std::copy(neighbour_.begin() + start_[k], neighbour_.begin() + start_[k + 1], to));
    }
    start_.swap(start);
    neighbour_.swap(neighbour);
    std::iota(order_.begin(), order_.end(), 0);
}

double NeighbourList::mean_within_radius(const double* const* x) const {
    double pairs = 0;
    for (std::size_t row = 0; row < order_.size(); ++row)
        for (std::int64_t k = start_[row]; k < start_[row + 1]; ++k) {
            const std::int32_t i = order_[row];
            double d2 = 0;
            for (int a = 0; a < box_.dimension; ++a) {
                const double d = period_[a].nearest(x[a][i] - x[a][neighbour_[std::size_t(k)]]);
                d2 += d * d;
            }
            pairs += d2 < radius_ * radius_;
        }
    return pairs / double(n_);
}

double NeighbourList::bytes() const {
    return 8.0 * double(start_.size()) + 4.0 * double(order_.size() + neighbour_.size()) + 8.0 * double(n_ * box_.dimension);
}

}    // namespace sphonic
