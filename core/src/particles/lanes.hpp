#pragma once
#include <cstdint>
#include <cstring>
#ifdef __AVX512VL__
#include <immintrin.h>
#endif

namespace sphonic {

/// Doubles in the widest vector; narrower machines split it.
inline constexpr int lanes = 8;
using Lane = double __attribute__((vector_size(8 * lanes)));

/// The same width of either precision.
template <class Real>
inline constexpr int lanes_of = 64 / int(sizeof(Real));
template <class Real>
struct WidestVector;
template <>
struct WidestVector<double> {
    using Type = Lane;
};
template <>
struct WidestVector<float> {
    using Type = float __attribute__((vector_size(64)));
};
template <class Real>
using LaneOf = typename WidestVector<Real>::Type;

/// Values that vector-wise loops may read or write beyond the end of an array.
inline constexpr long overrun = lanes;

template <class Real>
inline LaneOf<Real> load(const Real* p) {
    LaneOf<Real> v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
template <class Real>
inline void store(Real* p, LaneOf<Real> v) { std::memcpy(p, &v, sizeof v); }

/// What comparing vectors gives: all bits set where true.
using Mask = decltype(Lane{} < Lane{});

/// The first n lanes, zeros in the others.
inline Lane first_lanes(Lane v, int n) {
    constexpr Mask number{0, 1, 2, 3, 4, 5, 6, 7};
    return number < long(n) ? v : Lane{};
}

/// The sum of all lanes.
inline double total(Lane v) {
    v += __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3);
    v += __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5);
    return v[0] + v[1];
}

/// Appends those of the first n <= lanes indices that are kept, and returns how many. Reads `lanes` indices.
inline int keep(Mask kept, int n, const std::int32_t* from, std::int32_t* to) {
#ifdef __AVX512VL__
    const unsigned mask = unsigned(_mm512_movepi64_mask(reinterpret_cast<__m512i>(kept))) & ((1u << n) - 1);
    const int count = __builtin_popcount(mask);
    const __m256i all = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    _mm256_mask_storeu_epi32(to, __mmask8((1u << count) - 1), _mm256_maskz_compress_epi32(__mmask8(mask), all));
    return count;
#else
    int count = 0;
    for (int l = 0; l < n; ++l) {
        if (kept[l]) to[count++] = from[l];
    }
    return count;
#endif
}

}    // namespace sphonic
