#pragma once
#include <cstdint>
#include <vector>

#include "store.hpp"

namespace sphonic {

/// Pairs of some consecutive particles, packed: pair k belongs to row `i` where first[i] <= k < first[i + 1].
/// Everything but packing and row sums runs flat over the pairs, in SIMD.
struct PairTile {
    long begin = 0, end = 0;    ///< particles
    int n = 0;                  ///< pairs
    std::vector<int> first;     ///< [end - begin + 1]
    const std::int32_t* j = nullptr;

    /// Calls row(particle, first pair, end of pairs).
    template <class Row>
    void for_rows(Row row) const {
        for (long i = begin; i < end; ++i) row(i, first[std::size_t(i - begin)], first[std::size_t(i - begin) + 1]);
    }
};

/// own[k] = f[i], other[k] = f[j] of each pair.
inline void pack(const PairTile& tile, const double* f, double* __restrict own, double* __restrict other) {
    const std::int32_t* j = tile.j;
    tile.for_rows([&](long i, int first, int last) {
        const double fi = f[i];
        for (int k = first; k < last; ++k) {
            own[k] = fi;
            other[k] = f[j[k]];
        }
    });
}

/// difference[k] = f[i] - f[j].
inline void pack_difference(const PairTile& tile, const double* f, double* __restrict difference) {
    const std::int32_t* j = tile.j;
    tile.for_rows([&](long i, int first, int last) {
        const double fi = f[i];
        for (int k = first; k < last; ++k) difference[k] = fi - f[j[k]];
    });
}

/// out[i] = scale * sum of value over the row, or added to it.
inline void row_sums(const PairTile& tile, const double* __restrict value, double scale, bool assign, double* out) {
    tile.for_rows([&](long i, int first, int last) {
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int k = first; k < last; ++k) sum += value[k];
        out[i] = assign ? scale * sum : out[i] + scale * sum;
    });
}

/// The same of value * factor.
inline void row_sums(const PairTile& tile, const double* __restrict value, const double* __restrict factor, double scale,
                     bool assign, double* out) {
    tile.for_rows([&](long i, int first, int last) {
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int k = first; k < last; ++k) sum += value[k] * factor[k];
        out[i] = assign ? scale * sum : out[i] + scale * sum;
    });
}

}    // namespace sphonic
