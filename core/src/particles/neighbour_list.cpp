#include "neighbour_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace sphonic {
namespace {

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

    /// The distinct cells around and including `c`, in a fixed order.
    std::vector<long> around(const std::array<long, 3>& c) const {
        std::vector<long> found;
        std::array<long, 3> low{}, high{};
        for (std::size_t a = 0; a < std::size_t(d_); ++a) low[a] = -1, high[a] = 1;
        for (long k = low[2]; k <= high[2]; ++k)
            for (long j = low[1]; j <= high[1]; ++j)
                for (long i = low[0]; i <= high[0]; ++i) {
                    std::array<long, 3> at{c[0] + i, c[1] + j, c[2] + k};
                    bool exists = true;
                    for (int a = 0; a < d_; ++a) {
                        long& v = at[std::size_t(a)];
                        if (periodic_[a])
                            v = (v + count_[a]) % count_[a];
                        else
                            exists = exists && v >= 0 && v < count_[a];
                    }
                    if (exists && std::find(found.begin(), found.end(), index(at)) == found.end()) found.push_back(index(at));
                }
        return found;
    }

    std::span<const std::int32_t> members(long cell) const {
        return {member_.data() + first_[std::size_t(cell)], std::size_t(first_[std::size_t(cell + 1)] - first_[std::size_t(cell)])};
    }
    long index(const std::array<long, 3>& c) const { return c[0] + count_[0] * (c[1] + count_[1] * c[2]); }
    long cells() const { return long(first_.size()) - 1; }
    std::array<long, 3> site(long cell) const {
        return {cell % count_[0], cell / count_[0] % count_[1], cell / (count_[0] * count_[1])};
    }

private:
    int d_;
    bool periodic_[3] = {};
    double lower_[3] = {}, width_[3] = {1, 1, 1};
    long count_[3] = {1, 1, 1};
    std::vector<std::int32_t> first_, member_;
    std::vector<long> cell_;
};

}    // namespace

NeighbourList::NeighbourList(const abi::Box& box, long particles, double radius, double skin)
    : box_(box), n_(particles), radius_(radius), skin_(skin) {
    for (int a = 0; a < box.dimension; ++a)
        if (box.periodic[a]) period_[a] = box.upper[a] - box.lower[a];
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
    const double limit = (radius_ + skin_) * (radius_ + skin_);
    const auto near = [&](long i, long j) {
        double d2 = 0;
        for (int a = 0; a < box_.dimension; ++a) {
            double d = x[a][i] - x[a][j];
            if (period_[a] > 0) d -= period_[a] * std::nearbyint(d / period_[a]);
            d2 += d * d;
        }
        return d2 < limit;
    };
    const auto for_neighbours = [&](auto found) {
        for (long c = 0; c < cells.cells(); ++c) {
            const auto around = cells.around(cells.site(c));
            for (const std::int32_t i : cells.members(c)) {
                if (i >= n_) continue;
                for (const long other : around)
                    for (const std::int32_t j : cells.members(other))
                        if (j != i && near(i, j)) found(i, j);
            }
        }
    };
    start_.assign(std::size_t(n_ + 1), 0);
    for_neighbours([&](std::int32_t i, std::int32_t) { ++start_[std::size_t(i) + 1]; });
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    neighbour_.resize(std::size_t(start_.back()));
    std::vector<std::int64_t> next(start_.begin(), start_.end() - 1);
    for_neighbours([&](std::int32_t i, std::int32_t j) { neighbour_[std::size_t(next[std::size_t(i)]++)] = j; });
    for (std::size_t i = 0; i + 1 < start_.size(); ++i) std::sort(neighbour_.begin() + start_[i], neighbour_.begin() + start_[i + 1]);
    find_runs();
}

void NeighbourList::find_runs() {
    runs_.clear();
    first_run_.assign(1, 0);
    for (long i = 0; i < n_; ++i) {
        for (std::int64_t k = start_[std::size_t(i)]; k < start_[std::size_t(i) + 1]; ++k) {
            const std::int32_t j = neighbour_[std::size_t(k)];
            const bool continues = k > start_[std::size_t(i)] && neighbour_[std::size_t(k) - 1] + 1 == j;
            if (continues)
                ++runs_.back().count;
            else
                runs_.push_back({j, 1});
        }
        first_run_.push_back(std::int64_t(runs_.size()));
    }
}

double NeighbourList::mean_within_radius(const double* const* x) const {
    double pairs = 0;
    for (long i = 0; i < n_; ++i)
        for (std::int64_t k = start_[std::size_t(i)]; k < start_[std::size_t(i) + 1]; ++k) {
            double d2 = 0;
            for (int a = 0; a < box_.dimension; ++a) {
                double d = x[a][i] - x[a][neighbour_[std::size_t(k)]];
                if (period_[a] > 0) d -= period_[a] * std::nearbyint(d / period_[a]);
                d2 += d * d;
            }
            pairs += d2 < radius_ * radius_;
        }
    return pairs / double(n_);
}

double NeighbourList::bytes() const {
    return 16.0 * double(start_.size()) + 4.0 * double(neighbour_.size()) + 8.0 * double(runs_.size()) + 8.0 * double(n_ * box_.dimension);
}

}    // namespace sphonic
