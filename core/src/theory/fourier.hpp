#pragma once
#include <array>
#include <complex>
#include <vector>

namespace sphonic {

using Complex = std::complex<double>;

/// F_k = sum_j f_j exp(sign 2 pi i sum_a j_a k_a / n_a) over an array of n[0] x n[1] x n[2] values, x fastest, in place and for any
/// n: each axis by its prime factors (Cooley and Tukey 1965). Both ways without a factor: there and back multiplies by the size.
void fourier(std::vector<Complex>& f, const std::array<long, 3>& n, int sign);

/// Products that this takes: large prime factors are dear.
double fourier_work(const std::array<long, 3>& n);

}    // namespace sphonic
