#include "eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace sphonic {

std::vector<std::complex<double>> eigenvalues(int n, const double* a) {
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> A(a, n, n);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(A, false);
    const auto& values = solver.eigenvalues();
    return {values.data(), values.data() + values.size()};
}

}    // namespace sphonic
