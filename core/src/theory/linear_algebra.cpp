#include "linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Spectra/LinAlg/Arnoldi.h>
#include <Spectra/MatOp/internal/ArnoldiOp.h>

namespace sphonic {
namespace {

auto view(int n, const double* a) {
    return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(a, n, n);
}

/// As Spectra asks for it.
struct Operator {
    using Scalar = double;
    long n;
    const std::function<void(const double* x, double* y)>& apply;

    Eigen::Index rows() const { return n; }
    Eigen::Index cols() const { return n; }
    void perform_op(const double* x, double* y) const { apply(x, y); }
};

}    // namespace

std::vector<RitzValue> ritz_values(long n, const std::function<void(const double* x, double* y)>& apply) {
    using Counted = Spectra::ArnoldiOp<double, Operator, Spectra::IdentityBOp>;
    const Operator op{n, apply};
    const Spectra::IdentityBOp plain;
    const long size = std::min({160L, n, std::max(20L, 50'000'000 / n)});
    Spectra::Arnoldi<double, Counted> space(Counted(op, plain), size);
    Eigen::VectorXd begin(n);
    Spectra::SimpleRandom<double>(1).random_vec(begin);
    Eigen::Index calls = 0;
    Eigen::Map<const Eigen::VectorXd> first(begin.data(), n);
    space.init(first, calls);
    space.factorize_from(1, size, calls);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(space.matrix_H());
    std::vector<RitzValue> found;
    for (long i = 0; i < size; ++i)
        found.push_back({solver.eigenvalues()[i], space.f_norm() * std::abs(solver.eigenvectors().col(i)[size - 1])});
    return found;
}

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
