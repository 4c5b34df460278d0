#pragma once
#include <complex>
#include <vector>

namespace sphonic {

/// Eigenvalues of a real n x n matrix, row-major. The one place that knows Eigen.
std::vector<std::complex<double>> eigenvalues(int n, const double* a);

}    // namespace sphonic
