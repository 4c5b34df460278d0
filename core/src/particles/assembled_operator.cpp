#include <algorithm>

#include <sphonic/stability.hpp>

#include "linear_algebra.hpp"
#include "particle_system.hpp"

namespace sphonic {

std::vector<double> ParticleSystem::assembled(Terms terms) {
    const Part& all = part(abi::fields);
    const abi::Slot rates = store_.history("core: rate");
    const std::size_t particles = std::size_t(this->particles()), n = all.components.size() * particles;
    const double* p = field(components_.first[std::size_t(pressure_)]);
    std::vector<double> matrix(n * n);
    for (std::size_t column = 0; column < n; ++column) {
        for (const int c : all.components) {
            std::fill_n(store_.array(abi::state, c), particles, 0.0);
            std::fill_n(store_.array(rates, c), particles, 0.0);
        }
        store_.array(abi::state, all.components[column / particles])[column % particles] = 1;
        refresh_algebraic(all, 0);
        for (const int c : all.components) tier_->fill_ghosts(c, store_.array(abi::state, c), p, 0);
        evaluate_terms(part(abi::fields), rates, 1, false, terms);
        for (std::size_t row = 0; row < n; ++row) matrix[row * n + column] = field(all.components[row / particles], rates)[row % particles];
    }
    return matrix;
}

Symbol assembled(const Case& scene, double dissipation) {
    ParticleSystem system(scene);
    Symbol A{.n = 0, .a = system.assembled(Terms::without_dissipation)};
    const std::vector<double> damping = system.assembled(Terms::dissipation_only);
    for (std::size_t k = 0; k < A.a.size(); ++k) A.a[k] += dissipation * damping[k];
    while (std::size_t(A.n) * std::size_t(A.n) < A.a.size()) ++A.n;
    return A;
}

std::vector<std::complex<double>> eigenvalues(const Symbol& matrix) { return eigenvalues(matrix.n, matrix.a.data()); }

}    // namespace sphonic
