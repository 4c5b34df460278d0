#pragma once
#include <cstdint>
#include <vector>

#include "lanes.hpp"
#include "store.hpp"

namespace sphonic {

/// Pairs of some particles that are visited one after another, packed: pair k belongs to the row of particle[m] where
/// first[m] <= k < first[m + 1]. Everything but packing and row sums runs flat over the pairs, in SIMD.
struct PairTile {
    long rows = 0;
    int n = 0;                                   ///< pairs
    std::int64_t base = 0;                       ///< index of the first pair in the list
    const std::int32_t* particle = nullptr;      ///< [rows]
    const std::int32_t* first = nullptr;         ///< [rows + 1]
    const std::int32_t* j = nullptr;             ///< the other particle of each pair, and `overrun` more

    /// Calls row(particle, first pair, end of pairs).
    template <class Row>
    void for_rows(Row row) const {
        for (long m = 0; m < rows; ++m) row(long(particle[m]), first[m], first[m + 1]);
    }
};

/// Sum of value(k), vectors of pairs from k on, over a row.
template <class Value>
inline double sum_of(int first, int last, Value value) {
    Lane sum = {};
    int k = first;
    for (; k + lanes <= last; k += lanes) sum += value(k);
    if (k < last) sum += first_lanes(value(k), last - k);
    return total(sum);
}

/// out[i] = scale * sum of value over the row, or added to it.
inline void row_sums(const PairTile& tile, const double* value, double scale, bool assign, double* out) {
    tile.for_rows([&](long i, int first, int last) {
        const double sum = sum_of(first, last, [&](int k) { return load(value + k); });
        out[i] = assign ? scale * sum : out[i] + scale * sum;
    });
}

/// The same of value * factor.
inline void row_sums(const PairTile& tile, const double* value, const double* factor, double scale, bool assign, double* out) {
    tile.for_rows([&](long i, int first, int last) {
        const double sum = sum_of(first, last, [&](int k) { return load(value + k) * load(factor + k); });
        out[i] = assign ? scale * sum : out[i] + scale * sum;
    });
}

}    // namespace sphonic
