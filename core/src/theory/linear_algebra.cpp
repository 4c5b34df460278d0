#include "linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace sphonic {
namespace {

auto view(int n, const double* a) {
    return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(a, n, n);
}

}    // namespace

std::vector<std::complex<double>> eigenvalues(int n, const double* a) {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(view(n, a), false);
    const auto& values = solver.eigenvalues();
    return {values.data(), values.data() + values.size()};
}

std::vector<std::complex<double>> solve_shifted(int n, const double* a, std::complex<double> shift, const std::complex<double>* b) {
    Eigen::MatrixXcd matrix = -view(n, a).cast<std::complex<double>>();
    matrix.diagonal().array() += shift;
    const Eigen::VectorXcd x = matrix.partialPivLu().solve(Eigen::Map<const Eigen::VectorXcd>(b, n));
    return {x.data(), x.data() + n};
}

}    // namespace sphonic
