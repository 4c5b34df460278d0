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

}    // namespace

/// A term with what does not depend on k: one of each pair of neighbours o and -o, and a number of each.
struct LatticeOperator::Part {
    const Term* term;
    int row, column = 0;                ///< first rows of the term's variable and of its operand
    double factor = 0;                  ///< before the sum
    std::vector<Offset> pairs;          ///< with the weights of the term
    std::vector<double> coefficient;    ///< by pair: of viscosities and dissipations
    std::vector<Offset> gradient{};     ///< that a dissipation corrects by
};

namespace {

using Part = LatticeOperator::Part;

void prepare_derivative(const Case& scene, const Term& term, const std::vector<Offset>& all, int medium, Part& part) {
    const abi::Medium& m = scene.media->list()[std::size_t(medium)];
    const double other = rest_coefficients(*term.form, derivative(term), m, m).other;
    part.factor = 2 * other * scene.behind(term.operand).slope * rest_coefficient(scene, term, medium);
    part.pairs = half_neighbours(weighted_neighbours(scene, term, all, medium));
}

void prepare_viscosity(const Case& scene, const Term& term, const std::vector<Offset>& all, Part& part) {
    part.factor = scene.medium.rho0 * lattice_volume(scene.box);
    part.pairs = half_neighbours(all);
    for (const Offset& n : part.pairs) part.coefficient.push_back(rest_slope(*term.viscosity, scene, scene.kernels[std::size_t(term.kernel)], n.r2));
}

void prepare_dissipation(const Case& scene, const Term& term, const std::vector<Offset>& all, int medium, Part& part) {
    part.factor = scene.media->list()[std::size_t(medium)].c0 / scene.medium.c0 * term.coefficient[std::size_t(medium)];
    part.pairs = half_neighbours(all);
    part.coefficient = rest_couplings(*term.dissipation, scene, scene.kernels[std::size_t(term.kernel)], part.pairs);
    part.gradient = half_neighbours(weighted_neighbours(scene, term, all));
}

void add_derivative(const Case& scene, const Part& part, const double* k, const Matrix& A) {
    const bool gradient = part.term->op == Term::Operator::gradient;
    for (const Offset& n : part.pairs) {
        const double s = part.factor * std::sin(phase(scene, n, k));
        for (int a = 0; a < scene.box.dimension; ++a) {
            if (gradient)
                A(part.row + a, part.column) += n.gradient[a] * s;
            else
                A(part.row, part.column + a) -= n.gradient[a] * s;
        }
    }
}

void add_viscosity(const Case& scene, const Part& part, const double* k, double strength, const Matrix& A) {
    for (std::size_t i = 0; i < part.pairs.size(); ++i) {
        const Offset& n = part.pairs[i];
        const double even = 2 * (1 - std::cos(phase(scene, n, k)));
        for (int a = 0; a < scene.box.dimension; ++a)
            for (int b = 0; b < scene.box.dimension; ++b)
                A(part.row + a, part.row + b) += strength * part.factor * part.coefficient[i] * even * n.o[b] * scene.box.dx * n.gradient[a];
    }
}

/// alpha sum a [ 2 (cos theta - 1) + G . o dx sin theta ] over half of the neighbours, where theta = k . o dx and i G is the
/// symbol of the corrected gradient.
void add_dissipation(const Case& scene, const Part& part, const double* k, double strength, const Matrix& A) {
    double G[3] = {0, 0, 0}, sum = 0;
    for (const Offset& n : part.gradient)
        for (int a = 0; a < scene.box.dimension; ++a) G[a] += 2 * n.gradient[a] * std::sin(phase(scene, n, k));
    for (std::size_t i = 0; i < part.pairs.size(); ++i) {
        const double theta = phase(scene, part.pairs[i], k);
        double along = 0;
        for (int a = 0; a < scene.box.dimension; ++a) along += G[a] * part.pairs[i].o[a] * scene.box.dx;
        sum += part.coefficient[i] * (2 * (std::cos(theta) - 1) + along * std::sin(theta));
    }
    const int components = scene.equations.variables[std::size_t(part.term->operand)].components(scene.box.dimension);
    for (int a = 0; a < components; ++a) A(part.row + a, part.row + a) += strength * part.factor * sum;
}

double largest_frequency(const Symbol& s) {
    double largest = 0;
    for (const auto& value : eigenvalues(s.n, s.a.data())) largest = std::max(largest, std::abs(value));
    return largest;
}

}    // namespace

LatticeOperator::LatticeOperator(const Case& scene, int medium) : scene_(scene) {
    const Equations& e = scene.equations;
    const std::vector<int> rows = rows_of(e, scene.box.dimension, n_);
    std::vector<std::vector<Offset>> all;
    for (const KernelUse& use : scene.kernels) all.push_back(lattice_neighbours(scene.box, use));
    for (std::size_t v = 0; v < e.variables.size(); ++v)
        for (const Term& term : e.variables[v].terms) {
            const auto& neighbours = all[std::size_t(term.kernel)];
            Part part{.term = &term, .row = rows[v], .pairs = {}, .coefficient = {}};
            if (term.op == Term::Operator::viscosity) {
                prepare_viscosity(scene, term, neighbours, part);
            } else if (term.op == Term::Operator::dissipation) {
                prepare_dissipation(scene, term, neighbours, medium, part);
            } else {
                prepare_derivative(scene, term, neighbours, medium, part);
                part.column = rows[std::size_t(scene.behind(term.operand).variable)];
            }
            parts_.push_back(std::move(part));
        }
}

LatticeOperator::~LatticeOperator() = default;

Symbol LatticeOperator::symbol(const double* k, Damping damping) const {
    Symbol result{.n = n_, .a = std::vector<double>(std::size_t(n_ * n_), 0.0)};
    const Matrix A{result};
    for (const Part& part : parts_) {
        if (part.term->op == Term::Operator::viscosity)
            add_viscosity(scene_, part, k, damping.viscosity, A);
        else if (part.term->op == Term::Operator::dissipation)
            add_dissipation(scene_, part, k, damping.dissipation, A);
        else
            add_derivative(scene_, part, k, A);
    }
    return result;
}

double LatticeOperator::dispersion(double k, const double* direction) const {
    double vector[3] = {0, 0, 0};
    for (int a = 0; a < scene_.box.dimension; ++a) vector[a] = k * direction[a];
    return largest_frequency(symbol(vector, undamped)) / scene_.medium.c0;
}

double LatticeOperator::long_wave_speed(const double* direction) const {
    const double k = 1e-3 / scene_.radius();    // the next term of the expansion is of relative order (k radius)^2 = 1e-6
    const double coarse = dispersion(2 * k, direction) / (2 * k), fine = dispersion(k, direction) / k;
    return (4 * fine - coarse) / 3;
}

Symbol symbol(const Case& scene, const double* k, Damping damping, int medium) { return LatticeOperator(scene, medium).symbol(k, damping); }
double dispersion(const Case& scene, double k, const double* direction) { return LatticeOperator(scene).dispersion(k, direction); }
double long_wave_speed(const Case& scene, const double* direction) { return LatticeOperator(scene).long_wave_speed(direction); }

std::vector<std::complex<double>> eigenvalues(const Symbol& matrix) { return eigenvalues(matrix.n, matrix.a.data()); }

}    // namespace sphonic
