#include <sphonic/stability.hpp>

#include <cmath>

#include "linear_algebra.hpp"
#include "stencil.hpp"

namespace sphonic {
namespace {

/// Writes into a symbol by row and column.
struct Matrix {
    Symbol& symbol;
    double& operator()(int row, int column) const { return symbol.a[std::size_t(row * symbol.n + column)]; }
};

/// Row of each evolved variable's first component.
std::vector<int> rows_of(const Equations& e, int dimension, int& count) {
    std::vector<int> row(e.variables.size(), -1);
    for (std::size_t v = 0; v < row.size(); ++v)
        if (e.variables[v].evolved()) {
            row[v] = count;
            count += e.variables[v].components(dimension);
        }
    return row;
}

/// Value of a variable at rest: densities are rho0, all else is zero.
double at_rest(const Case& scene, int v) { return v == scene.equations.density ? scene.medium.rho0 : 0; }

double rest_coefficient(const Case& scene, const Term& term, int medium) {
    double value = term.coefficient[std::size_t(medium)];
    for (const Factor& f : term.factors) value *= std::pow(at_rest(scene, f.variable), f.power);
    return value;
}

double phase(const Case& scene, const Offset& n, const double* k) {
    double sum = 0;
    for (int a = 0; a < scene.box.dimension; ++a) sum += k[a] * n.o[a] * scene.box.dx;
    return sum;
}

void add_derivative(const Case& scene, const Term& term, const std::vector<Offset>& all, const double* k, int row,
                    const std::vector<int>& rows, int medium, const Matrix& A) {
    const abi::Medium& m = scene.media->list()[std::size_t(medium)];
    const double other = rest_coefficients(*term.form, derivative(term), m, m).other;
    const auto [base, slope] = scene.behind(term.operand);
    const double factor = 2 * other * slope * rest_coefficient(scene, term, medium);
    for (const Offset& n : half_neighbours(weighted_neighbours(scene, term, all, medium))) {
        const double s = std::sin(phase(scene, n, k));
        for (int a = 0; a < scene.box.dimension; ++a) {
            const double entry = factor * n.gradient[a] * s;
            if (term.op == Term::Operator::gradient)
                A(row + a, rows[std::size_t(base)]) += entry;
            else
                A(row, rows[std::size_t(base)] + a) -= entry;
        }
    }
}

void add_viscosity(const Case& scene, const Term& term, const std::vector<Offset>& all, const double* k, int row,
                   double strength, const Matrix& A) {
    const KernelUse& kernel = scene.kernels[std::size_t(term.kernel)];
    const double mass = scene.medium.rho0 * lattice_volume(scene.box);
    for (const Offset& n : half_neighbours(all)) {
        const double slope = rest_slope(*term.viscosity, scene, kernel, n.r2);
        const double even = 2 * (1 - std::cos(phase(scene, n, k)));
        for (int a = 0; a < scene.box.dimension; ++a)
            for (int b = 0; b < scene.box.dimension; ++b)
                A(row + a, row + b) += strength * mass * slope * even * n.o[b] * scene.box.dx * n.gradient[a];
    }
}

/// alpha sum a [ 2 (cos theta - 1) + G . o dx sin theta ] over half of the neighbours, where theta = k . o dx and i G is the
/// symbol of the corrected gradient.
void add_dissipation(const Case& scene, const Term& term, const std::vector<Offset>& all, const double* k, int row,
                     double strength, int medium, const Matrix& A) {
    double G[3] = {0, 0, 0}, sum = 0;
    for (const Offset& n : half_neighbours(weighted_neighbours(scene, term, all)))
        for (int a = 0; a < scene.box.dimension; ++a) G[a] += 2 * n.gradient[a] * std::sin(phase(scene, n, k));
    const std::vector<Offset> half = half_neighbours(all);
    const auto couplings = rest_couplings(*term.dissipation, scene, scene.kernels[std::size_t(term.kernel)], half);
    for (std::size_t n = 0; n < half.size(); ++n) {
        const double theta = phase(scene, half[n], k);
        double along = 0;
        for (int a = 0; a < scene.box.dimension; ++a) along += G[a] * half[n].o[a] * scene.box.dx;
        sum += couplings[n] * (2 * (std::cos(theta) - 1) + along * std::sin(theta));
    }
    const double faster = scene.media->list()[std::size_t(medium)].c0 / scene.medium.c0;
    const int components = scene.equations.variables[std::size_t(term.operand)].components(scene.box.dimension);
    for (int a = 0; a < components; ++a) A(row + a, row + a) += strength * faster * term.coefficient[std::size_t(medium)] * sum;
}

double largest_frequency(const Symbol& s) {
    double largest = 0;
    for (const auto& value : eigenvalues(s.n, s.a.data())) largest = std::max(largest, std::abs(value));
    return largest;
}

}    // namespace

Symbol symbol(const Case& scene, const double* k, Damping damping, int medium) {
    Symbol result;
    const Equations& e = scene.equations;
    const std::vector<int> rows = rows_of(e, scene.box.dimension, result.n);
    result.a.assign(std::size_t(result.n * result.n), 0.0);
    const Matrix A{result};
    std::vector<std::vector<Offset>> all;
    for (const KernelUse& use : scene.kernels) all.push_back(lattice_neighbours(scene.box, use));
    for (std::size_t v = 0; v < e.variables.size(); ++v)
        for (const Term& term : e.variables[v].terms) {
            const auto& neighbours = all[std::size_t(term.kernel)];
            if (term.op == Term::Operator::viscosity)
                add_viscosity(scene, term, neighbours, k, rows[v], damping.viscosity, A);
            else if (term.op == Term::Operator::dissipation)
                add_dissipation(scene, term, neighbours, k, rows[v], damping.dissipation, medium, A);
            else
                add_derivative(scene, term, neighbours, k, rows[v], rows, medium, A);
        }
    return result;
}

double dispersion(const Case& scene, double k, const double* direction) {
    double vector[3] = {0, 0, 0};
    for (int a = 0; a < scene.box.dimension; ++a) vector[a] = k * direction[a];
    return largest_frequency(symbol(scene, vector, undamped)) / scene.medium.c0;
}

double long_wave_speed(const Case& scene, const double* direction) {
    const double k = 1e-3 / scene.radius();    // the next term of the expansion is of relative order (k radius)^2 = 1e-6
    const double coarse = dispersion(scene, 2 * k, direction) / (2 * k), fine = dispersion(scene, k, direction) / k;
    return (4 * fine - coarse) / 3;
}

std::vector<std::complex<double>> eigenvalues(const Symbol& matrix) { return eigenvalues(matrix.n, matrix.a.data()); }

}    // namespace sphonic
