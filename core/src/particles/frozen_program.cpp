#include <algorithm>
#include <cmath>

#include "frozen_dissipation.hpp"
#include "frozen_viscosity.hpp"
#include "lanes.hpp"
#include "pair_rows.hpp"
#include "parallel.hpp"
#include "stencil.hpp"

namespace sphonic {
namespace {

/// A gradient or a divergence as rows of constant weights.
class FrozenDerivative {
public:
    FrozenDerivative(const PairSet& set, FrozenWeightStore& weights, const Term& term, std::vector<int> target, bool first)
        : set_(set), weights_(weights.of(term)), gradient_(term.op == Term::Operator::gradient),
          first_(first), target_(std::move(target)), factors_(term.factors), coefficient_(term.coefficient) {
        if (!weights.holds_coefficients(term)) {
            const RestCoefficients c = rest_coefficients(*term.form, derivative(term), set.scene.medium, set.scene.medium);
            own_ = c.own;
            other_ = c.other;
        }
        operand_ = set.components.first[std::size_t(term.operand)];
    }

    void apply(const Evaluation& e, long begin, long end) const {
        switch (set_.scene.box.dimension) {
            case 1: return apply_where<1>(e, begin, end);
            case 2: return apply_where<2>(e, begin, end);
            default: return apply_where<3>(e, begin, end);
        }
    }

    /// Do rows share their weights?
    bool runs() const { return !weights_.runs.empty() && factors_.empty() && !set_.media.several(); }

private:
    const PairSet& set_;
    const FrozenWeights& weights_;
    bool gradient_, first_;
    std::vector<int> target_;
    std::vector<Factor> factors_;
    std::vector<double> coefficient_;    ///< by medium
    double own_ = 1, other_ = 1;
    int operand_;

    template <int D>
    void apply_where(const Evaluation& e, long begin, long end) const {
        if (!runs()) return apply_in<D>(e, begin, end);
        over_runs(weights_.runs, begin, end, [&](long first, long from, long to) { apply_run<D>(e, first, from, to); },
                  [&](long from, long to) { apply_in<D>(e, from, to); });
    }

    template <int D>
    void apply_run(const Evaluation& e, long first, long begin, long end) const {
        const auto in_vectors = [&]<int N>(std::integral_constant<int, N>) {
            for (; begin + N * lanes <= end; begin += N * lanes) gradient_ ? apply_vectors<D, N, true>(e, first, begin) : apply_vectors<D, N, false>(e, first, begin);
        };
        in_vectors(std::integral_constant<int, 4>());
        in_vectors(std::integral_constant<int, 1>());
        apply_in<D>(e, begin, end);
    }

    /// For N vectors of particles from i on, by the row of the first of their run.
    template <int D, int N, bool gradient>
    void apply_vectors(const Evaluation& e, long first, long i) const {
        constexpr int sums = gradient ? D : 1;
        const std::int64_t begin = set_.list.start()[std::size_t(first)], end = set_.list.start()[std::size_t(first) + 1];
        const std::int32_t* j = set_.list.neighbour().data();
        Lane sum[sums][N] = {};
        const auto add = [&](const auto& weight, std::int64_t k, double factor, long from) {
            for (int a = 0; a < D; ++a)
                for (int v = 0; v < N; ++v) sum[gradient ? a : 0][v] += factor * weight[a].data()[k] * load(e.state[operand_ + (gradient ? 0 : a)] + from + v * lanes);
        };
        add(weights_.own, first, own_, i);
        for (std::int64_t k = begin; k < end; ++k) add(weights_.other, k, other_, i + (j[k] - first));
        const double scale = e.scale * coefficient_[0];
        for (int a = 0; a < sums; ++a)
            for (int v = 0; v < N; ++v) {
                double* out = e.out[target_[std::size_t(a)]] + i + v * lanes;
                store(out, (e.assign && first_ ? Lane{} : load(out)) + scale * sum[a][v]);
            }
    }

    template <int D>
    void apply_in(const Evaluation& e, long begin, long end) const {
        const bool assign = e.assign && first_;
        for (long i = begin; i < end; ++i) {
            const double scale = e.scale * coefficient_[std::size_t(set_.media.number(i))] * factor(e, i);
            double sum[D];
            if (gradient_)
                gradient<D>(e.state[operand_], i, sum);
            else
                sum[0] = divergence<D>(e.state + operand_, i);
            for (int a = 0; a < (gradient_ ? D : 1); ++a) {
                double& out = e.out[target_[std::size_t(a)]][i];
                out = (assign ? 0 : out) + scale * sum[a];
            }
        }
    }

    double factor(const Evaluation& e, long i) const {
        double product = 1;
        for (const Factor& f : factors_) {
            const double value = e.state[set_.components.first[std::size_t(f.variable)]][i];
            for (int p = 0; p < std::abs(f.power); ++p) product = f.power > 0 ? product * value : product / value;
        }
        return product;
    }

    template <int D>
    void gradient(const double* f, long i, double* sum) const {
        const std::int64_t *start = set_.list.start().data();
        const std::int32_t* j = set_.list.neighbour().data();
        const double* w[3] = {weights_.other[0].data(), weights_.other[1].data(), weights_.other[2].data()};
        const auto all = row_sum<D>(start[i], start[i + 1], [&](std::int64_t k, int a) { return w[a][k] * f[j[k]]; });
        for (int a = 0; a < D; ++a) sum[a] = other_ * all[std::size_t(a)] + own_ * weights_.own[a].data()[i] * f[i];
    }

    template <int D>
    double divergence(const double* const* f, long i) const {
        const std::int64_t *start = set_.list.start().data();
        const std::int32_t* j = set_.list.neighbour().data();
        const double* w[3] = {weights_.other[0].data(), weights_.other[1].data(), weights_.other[2].data()};
        const double* u[3] = {f[0], f[D > 1 ? 1 : 0], f[D > 2 ? 2 : 0]};
        const auto all = row_sum<D>(start[i], start[i + 1], [&](std::int64_t k, int a) { return w[a][k] * u[a][j[k]]; });
        double sum = 0;
        for (int a = 0; a < D; ++a) sum += other_ * all[std::size_t(a)] + own_ * weights_.own[a].data()[i] * u[a][i];
        return sum;
    }
};

/// All terms of some variables, a few particles at a time.
class FrozenProgram final : public Program {
public:
    FrozenProgram(const PairSet& set, FrozenWeightStore& weights, const std::vector<int>& variables) : set_(set) {
        for (const int v : variables) {
            const Variable& variable = set.scene.equations.variables[std::size_t(v)];
            std::vector<int> target;
            for (int c = 0; c < variable.components(set.scene.box.dimension); ++c) target.push_back(set.components.first[std::size_t(v)] + c);
            bool first = true, damped = false;
            for (const Term& term : variable.terms) {
                if (term.op == Term::Operator::dissipation) {
                    dissipations_.emplace_back(set, weights, term);
                    continue;
                }
                if (term.op == Term::Operator::viscosity) {
                    viscosities_.emplace_back(set, weights, term, target);
                    continue;
                }
                derivatives_.emplace_back(set, weights, term, target, first);
                if (!term.fitted.empty() && !damped) dampings_.emplace_back(set, weights.cloud().of(term), target), damped = true;
                first = false;
            }
            if (first) still_.insert(still_.end(), target.begin(), target.end());
        }
    }

    void evaluate(const Evaluation& e) override {
        if (e.terms != Terms::dissipation_only) evaluate_others(e);
        if (e.terms == Terms::without_dissipation) return;
        for (FrozenDissipation& dissipation : dissipations_) dissipation.apply(e);
    }

private:
    const PairSet& set_;
    std::vector<FrozenDerivative> derivatives_;
    std::vector<CloudDamping> dampings_;
    std::vector<FrozenDissipation> dissipations_;
    std::vector<int> still_;    ///< components without a derivative
    std::vector<FrozenViscosity> viscosities_;

    void evaluate_others(const Evaluation& e) {
        if (e.assign)
            for (const int c : still_) std::fill_n(e.out[c], set_.layout.size, 0.0);
        for (FrozenViscosity& viscosity : viscosities_) viscosity.fill(e);
        const long few = std::ranges::all_of(derivatives_, &FrozenDerivative::runs) ? 1024 : 32;    // whose weights stay in the first-level cache from term to term, or that share them
        in_blocks(set_.threads, set_.layout.particles(), [&](long block, long end_of_block) {
            for (long begin = block; begin < end_of_block; begin += few) {
                const long end = std::min(begin + few, end_of_block);
                for (const FrozenDerivative& derivative : derivatives_) derivative.apply(e, begin, end);
                for (const FrozenViscosity& viscosity : viscosities_) viscosity.apply(e, begin, end);
                for (const CloudDamping& damping : dampings_) damping.apply(e, begin, end);
            }
        });
    }
};

}    // namespace

std::unique_ptr<Program> make_frozen_program(const PairSet& set, FrozenWeightStore& weights, const std::vector<int>& variables) {
    return std::make_unique<FrozenProgram>(set, weights, variables);
}

}    // namespace sphonic
