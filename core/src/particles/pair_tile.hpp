#pragma once
#include <cstdint>
#include <vector>

#include "lanes.hpp"
#include "neighbour_list.hpp"
#include "store.hpp"

namespace sphonic {

/// Pairs of some consecutive particles, packed: pair k belongs to row `i` where first[i] <= k < first[i + 1].
/// Everything but packing and row sums runs flat over the pairs, in SIMD.
struct PairTile {
    long begin = 0, end = 0;    ///< particles
    int n = 0;                  ///< pairs
    std::int64_t base = 0;      ///< index of the first pair in the whole list
    std::vector<int> first;     ///< [end - begin + 1]
    const std::int64_t* first_run = nullptr;    ///< of particle `begin`
    const Run* runs = nullptr;                  ///< of the whole set

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

/// Packs all fields row by row. Runs of consecutive neighbours are copied by whole vectors: what a copy writes beyond its
/// run the next one overwrites, so fields and packed arrays have room for `overrun` more values.
inline void pack(const PairTile& tile, const std::vector<Packing>& fields) {
    const std::int64_t* first_run = tile.first_run;
    tile.for_rows([&](long i, int first, int last) {
        const Run *begin = tile.runs + first_run[0], *end = tile.runs + first_run[1];
        ++first_run;
        for (const Packing& field : fields) {
            const Lane own = field.f[i] - Lane{};
            double* other = field.other + first;
            const auto copy = [&](auto value) {
                for (const Run* run = begin; run != end; other += run++->count)
                    for (int m = 0; m < run->count; m += lanes) store(other + m, value(load(field.f + run->j + m)));
            };
            if (!field.own) {
                copy([&](Lane f) { return own - f; });
                continue;
            }
            copy([](Lane f) { return f; });
            for (int k = first; k < last; k += lanes) store(field.own + k, own);
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
