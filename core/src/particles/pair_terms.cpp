#include "pair_terms.hpp"

#include <cmath>

#include "stencil.hpp"

namespace sphonic {
namespace {

/// value = a f_i + b f_j, or, with separations, a f_i r_i + b f_j r_j, assigned or added. Each of a, b is uniform if its stride is 0.
struct Combination {
    int n;
    const double *f_i, *f_j;
    const double *r_i, *r_j;    ///< the same unless corrected; null for none
    bool assign;

    void sweep(double* __restrict value, auto a, auto b) const {
        const double *__restrict fi = f_i, *__restrict fj = f_j, *__restrict ri = r_i, *__restrict rj = r_j;
        const auto put = [&](auto pair) {
            if (assign)
                for (int k = 0; k < n; ++k) value[k] = pair(k);
            else
                for (int k = 0; k < n; ++k) value[k] += pair(k);
        };
        if (!ri)
            put([=](int k) { return a(k) * fi[k] + b(k) * fj[k]; });
        else if (ri == rj)
            put([=](int k) { return (a(k) * fi[k] + b(k) * fj[k]) * ri[k]; });
        else
            put([=](int k) { return a(k) * fi[k] * ri[k] + b(k) * fj[k] * rj[k]; });
    }
};

}    // namespace

void PairTerms::start(const PairTile& tile, PairValues& pairs) {
    for (std::size_t i = 0; i < corrections_.size(); ++i)
        if (corrections_[i]) corrected_[i].start(set_, *corrections_[i], tile, pairs);
}

void PairTerms::add(const Term& term, PairValues& pairs, double* sum, bool assign) {
    if (term.op == Term::Operator::viscosity)
        add_viscosity(term, pairs, sum, assign);
    else
        add_derivative(term, pairs, sum, assign);
}

const double* PairTerms::gradient(const Term& term, PairValues& pairs, int axis) {
    double* value = pairs.room(value_);
    combine(term, pairs, axis, value);
    for (const Factor& factor : term.factors) multiply(value, pairs, factor);
    return value;
}

void PairTerms::add_derivative(const Term& term, PairValues& pairs, double* __restrict sum, bool assign) {
    double* __restrict value = pairs.room(value_);
    combine(term, pairs, 0, value);
    const double coefficient = term.coefficient[0];
    const double* __restrict weight = pairs.weight(term.kernel);
    for (const Factor& factor : term.factors) multiply(value, pairs, factor);
    if (assign)
        for (int k = 0; k < pairs.n(); ++k) sum[k] = coefficient * value[k] * weight[k];
    else
        for (int k = 0; k < pairs.n(); ++k) sum[k] += coefficient * value[k] * weight[k];
}

std::pair<PairTerms::Coefficient, PairTerms::Coefficient> PairTerms::coefficients(const Term& term, PairValues& pairs) {
    double *own = pairs.room(own_), *other = pairs.room(other_);
    const int rho = set_.density();
    if (term.form->uniform() || rho < 0) {
        const RestCoefficients c = rest_coefficients(*term.form, derivative(term), set_.scene.medium, set_.scene.medium);
        own[0] = c.own, other[0] = c.other;
        return {{own, 0}, {other, 0}};
    }
    const double *rho_i = pairs.own(component(rho)), *rho_j = pairs.other(component(rho));
    double *Z_i = pairs.room(impedance_i_), *Z_j = pairs.room(impedance_j_);
    for (int k = 0; k < pairs.n(); ++k) {
        Z_i[k] = rho_i[k] * set_.scene.medium.c0;
        Z_j[k] = rho_j[k] * set_.scene.medium.c0;
    }
    term.form->coefficients(derivative(term), {pairs.n(), rho_i, rho_j, pairs.own_inverse_rho(), pairs.other_inverse_rho(), Z_i, Z_j},
                            own, other);
    return {{own, 1}, {other, 1}};
}

/// own f_i + other f_j: a divergence times the separations, along all axes; a corrected gradient times those of one axis.
void PairTerms::combine(const Term& term, PairValues& pairs, int axis, double* value) {
    const auto [own, other] = coefficients(term, pairs);
    const abi::Correction correction = term.form->correction();
    const CorrectedSeparations& corrected = corrected_[std::size_t(term.kernel)];
    const bool gradient = term.op == Term::Operator::gradient;
    for (int a = 0; a < (gradient ? 1 : set_.scene.box.dimension); ++a) {
        const int c = component(term.operand) + a, along = gradient ? axis : a;
        Combination sum{pairs.n(), pairs.own(c), pairs.other(c), nullptr, nullptr, a == 0};
        if (correction != abi::Correction::none) {
            sum.r_i = corrected.own(along);
            sum.r_j = correction == abi::Correction::own ? sum.r_i : corrected.other(along);
        } else if (!gradient) {
            sum.r_i = sum.r_j = pairs.r(a);
        }
        if (own.stride == 0)
            sum.sweep(value, [u = own.value[0]](int) { return u; }, [u = other.value[0]](int) { return u; });
        else
            sum.sweep(value, [u = own.value](int k) { return u[k]; }, [u = other.value](int k) { return u[k]; });
    }
}

void PairTerms::multiply(double* __restrict value, PairValues& pairs, const Factor& factor) const {
    const bool inverse = factor.power < 0, density = factor.variable == set_.density();
    const double* __restrict f = inverse && density ? pairs.own_inverse_rho() : pairs.own(component(factor.variable));
    const int n = pairs.n();
    for (int p = 0; p < std::abs(factor.power); ++p) {
        if (inverse && !density)
            for (int k = 0; k < n; ++k) value[k] /= f[k];
        else
            for (int k = 0; k < n; ++k) value[k] *= f[k];
    }
}

void PairTerms::add_viscosity(const Term& term, PairValues& pairs, double* __restrict sum, bool assign) {
    const int n = pairs.n(), rho = set_.density();
    double* __restrict u_dot_r = pairs.room(u_dot_r_);
    for (int a = 0; a < set_.scene.box.dimension; ++a) {
        const int c = component(term.operand) + a;
        const double *__restrict ui = pairs.own(c), *__restrict uj = pairs.other(c), *__restrict r = pairs.r(a);
        if (a == 0)
            for (int k = 0; k < n; ++k) u_dot_r[k] = (ui[k] - uj[k]) * r[k];
        else
            for (int k = 0; k < n; ++k) u_dot_r[k] += (ui[k] - uj[k]) * r[k];
    }
    abi::PairBlock block{.n = n, .u_dot_r = u_dot_r, .r2 = pairs.r2()};
    block.h = set_.scene.kernels[std::size_t(term.kernel)].h;
    block.c = set_.scene.medium.c0;
    block.rho = set_.scene.medium.rho0;
    if (rho >= 0) {
        double* __restrict mean = pairs.room(density_);
        const double *__restrict ri = pairs.own(component(rho)), *__restrict rj = pairs.other(component(rho));
        for (int k = 0; k < n; ++k) mean[k] = 0.5 * (ri[k] + rj[k]);
        block.rho_each = mean;
    }
    double* __restrict Pi = pairs.room(Pi_);
    term.viscosity->pairs(block, Pi);
    const double* __restrict slope = pairs.slope(term.kernel);
    const double mass = set_.mass;
    if (assign)
        for (int k = 0; k < n; ++k) sum[k] = -mass * slope[k] * Pi[k];
    else
        for (int k = 0; k < n; ++k) sum[k] -= mass * slope[k] * Pi[k];
}

}    // namespace sphonic
