#include <algorithm>
#include <cmath>

#include "pair_set.hpp"
#include "parallel.hpp"
#include "stencil.hpp"

namespace sphonic {
namespace {

/// Rate terms tile by tile, every term as one scalar per pair. One worker per thread.
class PairWorker {
public:
    PairWorker(const PairSet& set, const std::vector<Share>& shares)
        : set_(set), shares_(shares), pairs_(set, components_read(set, shares)) {}

    /// Tiles begin ... end - 1; `inverse_rho` of all particles where the set has a current density, else null.
    void evaluate(const Evaluation& e, const double* inverse_rho, long begin, long end) {
        pairs_.begin(e.state, inverse_rho);
        for (long i = begin; i < end; ++i) {
            take_tile(set_, i, tile_);
            pairs_.start(tile_);
            for (const Share& share : shares_) evaluate_share(share, tile_, pairs_, e);
        }
    }

private:
    const PairSet& set_;
    std::vector<Share> shares_;
    PairValues pairs_;
    PairTile tile_;
    Array sum_, density_, own_, other_, u_dot_r_, Pi_, value_, impedance_i_, impedance_j_;

    static std::vector<int> components_read(const PairSet& set, const std::vector<Share>& shares) {
        const Equations& e = set.scene.equations;
        std::vector<int> read;
        const auto add = [&](int v) {
            for (int c = 0; c < e.variables[std::size_t(v)].components(set.scene.box.dimension); ++c)
                read.push_back(set.components.first[std::size_t(v)] + c);
        };
        if (set.density() >= 0) add(set.density());
        for (const Share& share : shares)
            for (const Term* term : share.terms) {
                add(term->operand);
                for (const Factor& f : term->factors) add(f.variable);
            }
        std::sort(read.begin(), read.end());
        read.erase(std::unique(read.begin(), read.end()), read.end());
        return read;
    }

    const Variable& variable(int v) const { return set_.scene.equations.variables[std::size_t(v)]; }
    int component(int v) const { return set_.components.first[std::size_t(v)]; }

    /// All terms of a variable as one scalar per pair, which a vector multiplies by r_ij.
    void evaluate_share(const Share& share, const PairTile& tile, PairValues& pairs, const Evaluation& e) {
        double* sum = pairs.room(sum_);
        const int v = share.variable;
        if (share.terms.empty()) std::fill_n(sum, tile.n, 0.0);
        for (const Term* term : share.terms) {
            const bool first = term == share.terms.front();
            if (term->op == Term::Operator::viscosity)
                add_viscosity(*term, pairs, sum, first);
            else
                add_derivative(*term, pairs, sum, first);
        }
        if (!variable(v).is_vector) return row_sums(tile, sum, e.scale, e.assign, e.out[component(v)]);
        for (int a = 0; a < set_.scene.box.dimension; ++a)
            row_sums(tile, sum, pairs.r(a), e.scale, e.assign, e.out[component(v) + a]);
    }

    void add_derivative(const Term& term, PairValues& pairs, double* __restrict sum, bool first) {
        const auto [own, other] = coefficients(term, pairs);
        double* __restrict value = pairs.room(value_);
        const bool gradient = term.op == Term::Operator::gradient;
        for (int a = 0; a < (gradient ? 1 : set_.scene.box.dimension); ++a) {
            const int c = component(term.operand) + a;
            combine(pairs.n(), own, other, pairs.own(c), pairs.other(c), gradient ? nullptr : pairs.r(a), a == 0, value);
        }
        const double coefficient = term.coefficient;
        const double* __restrict weight = pairs.weight(term.kernel);
        for (const Factor& factor : term.factors) multiply(value, pairs, factor);
        if (first)
            for (int k = 0; k < pairs.n(); ++k) sum[k] = coefficient * value[k] * weight[k];
        else
            for (int k = 0; k < pairs.n(); ++k) sum[k] += coefficient * value[k] * weight[k];
    }

    /// Per-pair coefficients; a stride of 0 in `Coefficient` stands for a uniform one.
    struct Coefficient {
        const double* value;
        int stride;
    };

    std::pair<Coefficient, Coefficient> coefficients(const Term& term, PairValues& pairs) {
        double *own = pairs.room(own_), *other = pairs.room(other_);
        const int rho = set_.density();
        if (term.form->uniform() || rho < 0) {
            const RestCoefficients c = rest_coefficients(*term.form, derivative(term), set_.scene.medium);
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

    /// value = own f_i + other f_j, times r_a and added up over the axes for a divergence.
    static void combine(int n, Coefficient own, Coefficient other, const double* __restrict fi, const double* __restrict fj,
                        const double* __restrict r, bool first, double* __restrict value) {
        const auto sweep = [&](auto pair) {
            if (!r)
                for (int k = 0; k < n; ++k) value[k] = pair(k);
            else if (first)
                for (int k = 0; k < n; ++k) value[k] = pair(k) * r[k];
            else
                for (int k = 0; k < n; ++k) value[k] += pair(k) * r[k];
        };
        if (own.stride == 0) {
            const double a = own.value[0], b = other.value[0];
            sweep([=](int k) { return a * fi[k] + b * fj[k]; });
        } else {
            const double *a = own.value, *b = other.value;
            sweep([=](int k) { return a[k] * fi[k] + b[k] * fj[k]; });
        }
    }

    void multiply(double* __restrict value, PairValues& pairs, const Factor& factor) const {
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

    void add_viscosity(const Term& term, PairValues& pairs, double* __restrict sum, bool first) {
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
        if (first)
            for (int k = 0; k < n; ++k) sum[k] = -mass * slope[k] * Pi[k];
        else
            for (int k = 0; k < n; ++k) sum[k] -= mass * slope[k] * Pi[k];
    }
};

class PairProgram final : public Program {
public:
    PairProgram(const PairSet& set, const std::vector<Share>& shares) : set_(set) {
        for (int t = 0; t < set.threads; ++t) workers_.emplace_back(set, shares);
        if (set.density() >= 0) inverse_rho_ = Array(std::size_t(set.layout.size));
    }

    void evaluate(const Evaluation& e) override {
        if (inverse_rho_.data()) invert(e.state[set_.components.first[std::size_t(set_.density())]], inverse_rho_.data());
        const long n = tiles(set_), threads = set_.threads;
        in_parallel(set_.threads, threads, [&](long t) {
            workers_[std::size_t(t)].evaluate(e, inverse_rho_.data(), n * t / threads, n * (t + 1) / threads);
        });
    }

private:
    const PairSet& set_;
    std::vector<PairWorker> workers_;
    Array inverse_rho_;

    void invert(const double* rho, double* inverse) const {
        in_blocks(set_.threads, set_.layout.size, [=](long begin, long end) {
            const double* __restrict from = rho;
            double* __restrict to = inverse;
            for (long i = begin; i < end; ++i) to[i] = 1 / from[i];
        });
    }
};

}    // namespace

std::vector<Share> whole_shares(const Equations& equations, const std::vector<int>& variables) {
    std::vector<Share> shares;
    for (const int v : variables) {
        shares.push_back({v, {}});
        for (const Term& term : equations.variables[std::size_t(v)].terms) shares.back().terms.push_back(&term);
    }
    return shares;
}

std::unique_ptr<Program> make_pair_program(const PairSet& set, const std::vector<Share>& shares) {
    return std::make_unique<PairProgram>(set, shares);
}

}    // namespace sphonic
