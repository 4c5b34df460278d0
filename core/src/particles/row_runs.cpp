#include "row_runs.hpp"

#include <cmath>

namespace sphonic {

namespace {

constexpr long shortest = 16;
constexpr double rounding = 1e-12;    ///< of the largest weight

/// The rows of a set, without the pairs that weigh nothing: at the very end of a kernel's support rounding decides which are listed.
class Rows {
public:
    Rows(const NeighbourList& list, const Array* own, const Array* other) : list_(list), own_(own), other_(other) {}

    /// Is j's row that of i shifted along?
    bool alike(long i, long j) const {
        const double least = rounding * largest(i);
        Pair a = first(i, least), b = first(j, least);
        for (; a.inside() && b.inside(); a = next(a, least), b = next(b, least))
            if (neighbour(b) - neighbour(a) != j - i || differs(other_, a.k, b.k, least)) return false;
        return !a.inside() && !b.inside() && !differs(own_, i, j, least);
    }

private:
    const NeighbourList& list_;
    const Array *own_, *other_;

    struct Pair {
        std::int64_t k, end;
        bool inside() const { return k < end; }
    };

    long neighbour(const Pair& pair) const { return list_.neighbour()[std::size_t(pair.k)]; }
    double size(std::int64_t k) const {
        double most = 0;
        for (int a = 0; a < list_.dimension(); ++a) most = std::max(most, std::abs(other_[a].data()[k]));
        return most;
    }
    Pair skip(Pair pair, double least) const {
        while (pair.inside() && size(pair.k) <= least) ++pair.k;
        return pair;
    }
    Pair first(long i, double least) const { return skip({list_.start()[std::size_t(i)], list_.start()[std::size_t(i) + 1]}, least); }
    Pair next(Pair pair, double least) const { return skip({pair.k + 1, pair.end}, least); }
    double largest(long i) const {
        double most = 0;
        for (std::int64_t k = list_.start()[std::size_t(i)]; k < list_.start()[std::size_t(i) + 1]; ++k) most = std::max(most, size(k));
        return most;
    }
    bool differs(const Array* weight, std::int64_t i, std::int64_t j, double least) const {
        for (int a = 0; a < list_.dimension(); ++a)
            if (!(std::abs(weight[a].data()[i] - weight[a].data()[j]) <= least)) return true;
        return false;
    }
};

}    // namespace

std::vector<RowRun> runs_of_rows(const NeighbourList& list, long particles, const Array* own, const Array* other) {
    const Rows rows(list, own, other);
    std::vector<RowRun> runs;
    for (long begin = 0, end; begin < particles; begin = end) {
        for (end = begin + 1; end < particles && rows.alike(begin, end);) ++end;
        if (end - begin >= shortest) runs.push_back({begin, end});
    }
    return runs;
}

}    // namespace sphonic
