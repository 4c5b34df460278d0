#pragma once
/// Elementary functions that vectorise inside loops (std::exp and std::sin do not: the standard headers withhold the
/// SIMD variants of libmvec). Accurate to 4 ulp; a scalar call is the C library's own.

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
extern "C" {
__attribute__((simd("notinbranch"))) double exp(double) noexcept;
__attribute__((simd("notinbranch"))) double sin(double) noexcept;
__attribute__((simd("notinbranch"))) double cos(double) noexcept;
}
#endif

#include <cmath>
