#include "local_fit.hpp"

namespace sphonic {
namespace {

/// Least pivot of the normal equations, in units of their first.
constexpr double least_pivot = 1e-3;

}    // namespace

/// c with (sum_k weight_k g_k g_k) c = at, by elimination.
LocalFit::Basis LocalFit::solved(const Basis& at) const {
    std::array<Basis, most> A{};
    for (const Point& p : points_)
        for (std::size_t a = 0; a < n_; ++a)
            for (std::size_t b = 0; b < n_; ++b) A[a][b] += p.weight * p.functions[a] * p.functions[b];
    const double first = A[0][0];
    if (!(first > 0)) return {};
    Basis c = at;
    for (std::size_t k = 0; k < n_; ++k) {
        if (!(A[k][k] >= least_pivot * first)) return {at[0] / first};
        for (std::size_t i = k + 1; i < n_; ++i) {
            const double factor = A[i][k] / A[k][k];
            for (std::size_t j = k; j < n_; ++j) A[i][j] -= factor * A[k][j];
            c[i] -= factor * c[k];
        }
    }
    for (std::size_t k = n_; k-- > 0;) {
        for (std::size_t j = k + 1; j < n_; ++j) c[k] -= A[k][j] * c[j];
        c[k] /= A[k][k];
    }
    return c;
}

std::vector<double> LocalFit::weights(const Basis& at) const {
    const Basis c = solved(at);
    std::vector<double> w;
    for (const Point& p : points_) {
        double sum = 0;
        for (std::size_t a = 0; a < n_; ++a) sum += c[a] * p.functions[a];
        w.push_back(p.weight * sum);
    }
    return w;
}

}    // namespace sphonic
