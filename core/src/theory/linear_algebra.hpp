#pragma once
#include <complex>
#include <functional>
#include <vector>

/// The one place that knows Eigen and Spectra.
namespace sphonic {

/// Eigenvalues of a real n x n matrix, row-major.
std::vector<std::complex<double>> eigenvalues(int n, const double* a);

/// An eigenvalue as a Krylov space knows it, and how far at most the nearest one of a normal matrix is from it.
struct RitzValue {
    std::complex<double> value;
    double residual;
};
/// Those of the n x n matrix behind y = A x in the Krylov space of a random vector (Arnoldi 1951): they close in on the edges of its
/// spectrum first. Of at most 160 dimensions, fewer where so many vectors would take over 400 MB.
std::vector<RitzValue> ritz_values(long n, const std::function<void(const double* x, double* y)>& apply);

/// x of (shift I - A) x = b, for a real n x n matrix A, row-major.
std::vector<std::complex<double>> solve_shifted(int n, const double* a, std::complex<double> shift, const std::complex<double>* b);

}    // namespace sphonic
