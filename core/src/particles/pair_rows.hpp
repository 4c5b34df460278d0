#pragma once
#include <array>
#include <cstdint>

namespace sphonic {

/// Sums of value(k, a) over the pairs k of a row, for each a. Even and odd pairs have sums of their own, so that an addition need not
/// wait for the one before; SIMD with gathered loads takes twice as long.
template <int D, class Value>
inline std::array<double, D> row_sum(std::int64_t first, std::int64_t last, Value value) {
    std::array<double, D> even{}, odd{};
    std::int64_t k = first;
    for (; k + 2 <= last; k += 2)
        for (int a = 0; a < D; ++a) {
            even[std::size_t(a)] += value(k, a);
            odd[std::size_t(a)] += value(k + 1, a);
        }
    for (int a = 0; a < D; ++a) {
        if (k < last) even[std::size_t(a)] += value(k, a);
        even[std::size_t(a)] += odd[std::size_t(a)];
    }
    return even;
}

}    // namespace sphonic
