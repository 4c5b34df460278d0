#pragma once
#include <complex>
#include <vector>

/// The one place that knows Eigen.
namespace sphonic {

/// Eigenvalues of a real n x n matrix, row-major.
std::vector<std::complex<double>> eigenvalues(int n, const double* a);

/// x of (shift I - A) x = b, for a real n x n matrix A, row-major.
std::vector<std::complex<double>> solve_shifted(int n, const double* a, std::complex<double> shift, const std::complex<double>* b);

}    // namespace sphonic
