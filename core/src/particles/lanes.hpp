#pragma once
#include <cstring>

namespace sphonic {

/// Doubles in the widest vector; narrower machines split it.
inline constexpr int lanes = 8;
using Lane = double __attribute__((vector_size(8 * lanes)));

/// Values that vector-wise loops may read or write beyond the end of an array.
inline constexpr long overrun = lanes;

inline Lane load(const double* p) {
    Lane v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
inline void store(double* p, Lane v) { std::memcpy(p, &v, sizeof v); }

}    // namespace sphonic
