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

/// A field to pack: own[k] = f[i] and other[k] = f[j], or, where `own` is null, other[k] = f[i] - f[j].
struct Packing {
    const double* f;
    double* own;
    double* other;
};

/// Packs all fields row by row, so that the indices of a row are read once.
inline void pack(const PairTile& tile, const std::vector<Packing>& fields) {
    tile.for_rows([&](long i, int first, int last) {
        const std::int32_t* __restrict j = tile.j + first;
        const int n = last - first;
        for (const Packing& field : fields) {
            const double fi = field.f[i];
            double* __restrict other = field.other + first;
            if (!field.own) {
#pragma omp simd
                for (int k = 0; k < n; ++k) other[k] = fi - field.f[j[k]];
                continue;
            }
            double* __restrict own = field.own + first;
#pragma omp simd
            for (int k = 0; k < n; ++k) own[k] = fi;
#pragma omp simd
            for (int k = 0; k < n; ++k) other[k] = field.f[j[k]];
        }
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
