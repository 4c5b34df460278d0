#pragma once
#include <cstdint>

#include "lanes.hpp"
#include "store.hpp"

namespace sphonic {

/// One, two or four fields side by side, particle by particle: a pair finds all of j's values in one cache line, however
/// particles are numbered.
struct Interleaved {
    int width = 0;    ///< doubles per particle
    Array values;

    /// Room for up to four `fields` of n particles.
    void resize(int fields, long n) {
        const int needed = fields > 2 ? 4 : fields;
        if (needed == width && long(values.size()) >= needed * n) return;
        width = needed;
        values = Array(std::size_t(needed * n));
    }
    /// Takes over particles begin ... end - 1.
    void fill(const double* const* field, int fields, long begin, long end) {
        const double* f[4];
        for (int c = 0; c < 4; ++c) f[c] = field[c < fields ? c : 0];
        if (width == 1) return fill_in<1>(f, begin, end);
        if (width == 2) return fill_in<2>(f, begin, end);
        fill_in<4>(f, begin, end);
    }

private:
    template <int W>
    void fill_in(const double* const* f, long begin, long end) {
        const double *__restrict a = f[0], *__restrict b = f[1], *__restrict c = f[2], *__restrict d = f[3];
        double* __restrict to = values.data();
        for (long i = begin; i < end; ++i) {
            to[W * i] = a[i];
            if constexpr (W > 1) to[W * i + 1] = b[i];
            if constexpr (W > 2) to[W * i + 2] = c[i], to[W * i + 3] = d[i];
        }
    }
};

/// Values of `lanes` particles j, field by field: out[field][lane].
template <int W>
inline void take(const double* values, const std::int32_t* j, Lane* out) {
    if constexpr (W == 1) {
        for (int l = 0; l < lanes; ++l) out[0][l] = values[j[l]];
    } else if constexpr (W == 2) {
        using Two = double __attribute__((vector_size(16), may_alias));
        using Four = double __attribute__((vector_size(32), may_alias));
        const auto two = [&](int l) { return *reinterpret_cast<const Two*>(values + 2 * std::ptrdiff_t(j[l])); };
        const auto join = [](Two a, Two b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3); };
        const auto wide = [](Four a, Four b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7); };
        const Lane even = wide(join(two(0), two(2)), join(two(4), two(6))), odd = wide(join(two(1), two(3)), join(two(5), two(7)));
        out[0] = __builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14);
        out[1] = __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15);
    } else {
        using Four = double __attribute__((vector_size(32), may_alias));
        const auto four = [&](int l) { return *reinterpret_cast<const Four*>(values + 4 * std::ptrdiff_t(j[l])); };
        const auto wide = [&](int l) { return __builtin_shufflevector(four(l), four(l + 4), 0, 1, 2, 3, 4, 5, 6, 7); };
        const Lane a = wide(0), b = wide(1), c = wide(2), d = wide(3);
        const Lane ab02 = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14), ab13 = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
        const Lane cd02 = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14), cd13 = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
        out[0] = __builtin_shufflevector(ab02, cd02, 0, 1, 8, 9, 4, 5, 12, 13);
        out[1] = __builtin_shufflevector(ab13, cd13, 0, 1, 8, 9, 4, 5, 12, 13);
        out[2] = __builtin_shufflevector(ab02, cd02, 2, 3, 10, 11, 6, 7, 14, 15);
        out[3] = __builtin_shufflevector(ab13, cd13, 2, 3, 10, 11, 6, 7, 14, 15);
    }
}

}    // namespace sphonic
