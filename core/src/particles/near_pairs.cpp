#include "near_pairs.hpp"

#include <algorithm>

#include "parallel.hpp"

namespace sphonic {
namespace {

/// Pairs this much beyond the radius count as near: kernels vanish there, whatever the last digit of a distance.
constexpr double margin = 1e-9;

}    // namespace

void NearPairs::cut(long pairs_per_tile) {
    const auto& start = list_.start();
    const long n = long(start.size()) - 1;
    cuts_.assign(1, 0);
    for (long i = 1; i <= n; ++i)
        if (i == n || start[std::size_t(i) + 1] - start[std::size_t(cuts_.back())] > pairs_per_tile) cuts_.push_back(i);
    first_.assign(std::size_t(n + tiles()), 0);
    near_.clear();
}

void NearPairs::take_all() {
    j_ = list_.neighbour().data();
    for (long t = 0; t < tiles(); ++t)
        for (long k = begin(t); k <= begin(t + 1); ++k) first_[std::size_t(k + t)] = std::int32_t(list_.start()[std::size_t(k)] - base(t));
}

void NearPairs::narrow(const double* const* x, long n, int threads) {
    if (near_.empty()) near_.assign(list_.neighbour().size() + overrun, 0);
    j_ = near_.data();
    const int d = list_.dimension();
    places_.resize(d, n);
    in_blocks(threads, n, [&](long begin, long end) { places_.fill(x, d, begin, end); });
    in_parallel(threads, tiles(), [&](long t) { d == 1 ? narrow_tile<1>(x, t) : d == 2 ? narrow_tile<2>(x, t) : narrow_tile<3>(x, t); });
}

template <int D>
void NearPairs::narrow_tile(const double* const* x, long tile) {
    const std::int64_t* start = list_.start().data();
    const double limit = (1 + margin) * list_.radius() * list_.radius();
    std::int32_t *near = near_.data() + base(tile), *first = first_.data() + begin(tile) + tile;
    int count = 0;
    for (long row = begin(tile); row < begin(tile + 1); ++row) {
        const std::int32_t i = list_.order()[std::size_t(row)];
        for (std::int64_t k = start[row]; k < start[row + 1]; k += lanes) {
            const std::int32_t* j = list_.neighbour().data() + k;
            Lane other[4], r2 = {};
            take<D == 3 ? 4 : D>(places_.values.data(), j, other);
#pragma GCC unroll 3
            for (int a = 0; a < D; ++a) {
                const Lane r = list_.period(a).nearest(x[a][i] - other[a]);
                r2 += r * r;
            }
            count += keep(r2 < limit, int(std::min<std::int64_t>(lanes, start[row + 1] - k)), j, near + count);
        }
        first[row + 1 - begin(tile)] = count;
    }
}

}    // namespace sphonic
