#pragma once
#include <cmath>
#include <cstddef>

namespace sphonic::band {

/// A = L L^T in place: rows of the lower triangle of a positive definite n x n matrix, which L replaces. False if it is not.
inline bool factorise(double* A, int n) {
    for (int i = 0; i < n; ++i) {
        double* __restrict row = A + std::ptrdiff_t(i) * n;
        for (int j = 0; j <= i; ++j) {
            const double* above = A + std::ptrdiff_t(j) * n;
            double sum = 0;
#pragma omp simd reduction(+ : sum)
            for (int k = 0; k < j; ++k) sum += row[k] * above[k];
            if (i == j) {
                const double pivot = row[i] - sum;
                if (!(pivot > 0)) return false;
                row[i] = std::sqrt(pivot);
            } else {
                row[j] = (row[j] - sum) / above[j];
            }
        }
    }
    return true;
}

/// x = (L L^T)^-1 x in place.
inline void solve(const double* L, int n, double* x) {
    for (int i = 0; i < n; ++i) {
        const double* row = L + std::ptrdiff_t(i) * n;
        double sum = 0;
        for (int k = 0; k < i; ++k) sum += row[k] * x[k];
        x[i] = (x[i] - sum) / row[i];
    }
    for (int i = n - 1; i >= 0; --i) {
        const double* row = L + std::ptrdiff_t(i) * n;
        x[i] /= row[i];
        for (int k = 0; k < i; ++k) x[k] -= row[k] * x[i];
    }
}

}    // namespace sphonic::band
