#include "plain_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "parallel.hpp"
#include "stencil.hpp"

namespace sphonic {

std::optional<PlainRates> PlainRates::of(const PairSet& set, const std::vector<Share>& shares) {
    PlainRates rates;
    if (set.density() >= 0) return std::nullopt;
    for (const Share& share : shares) {
        if (share.terms.empty()) return std::nullopt;
        for (const Term* term : share.terms)
            if (!rates.add(set, share.variable, *term)) return std::nullopt;
    }
    const bool together = !rates.viscosity || (rates.gradient && (!rates.divergence || rates.divergence->operand == rates.viscosity->operand));
    const bool one_kernel = std::all_of(shares.begin(), shares.end(), [&](const Share& share) {
        return std::all_of(share.terms.begin(), share.terms.end(), [&](const Term* term) { return term->kernel == shares[0].terms[0]->kernel; });
    });
    if (shares.empty() || !together || !one_kernel) return std::nullopt;
    rates.kernel = shares[0].terms[0]->kernel;
    return rates;
}

bool PlainRates::add(const PairSet& set, int target, const Term& term) {
    if (term.op == Term::Operator::viscosity) return !std::exchange(viscosity, &term) && (!gradient || gradient->target == target);
    if (!term.form || !term.factors.empty() || !term.fitted.empty() || term.form->correction() != abi::Correction::none) return false;
    auto& place = term.op == Term::Operator::gradient ? gradient : divergence;
    if (place || (term.op == Term::Operator::gradient && viscosity)) return false;    // a viscosity follows its gradient
    const RestCoefficients c = rest_coefficients(*term.form, derivative(term), set.scene.medium, set.scene.medium);
    place = Derivative{target, term.operand, c.own, c.other, term.coefficient[0] * set.volume};
    return true;
}

namespace {

std::vector<int> components_read(const PairSet& set, const PlainRates& rates) {
    std::vector<int> read;
    const int d = set.scene.box.dimension;
    for (int a = 0; a < d && rates.vector() >= 0; ++a) read.push_back(set.components.first[std::size_t(rates.vector())] + a);
    if (rates.gradient) read.push_back(set.components.first[std::size_t(rates.gradient->operand)]);
    return read;
}

/// Tiles of pairs, for one thread.
class PlainWorker {
public:
    PlainWorker(const PairSet& set, const PlainRates& rates, const PairFields& fields) : set_(set), rates_(rates), fields_(fields) {}

    template <int D>
    void evaluate(const Evaluation& e, long begin, long end) {
        for (long t = begin; t < end; ++t) {
            take_tile(set_, t, tile_);
            make_room();
            if (rates_.vector() < 0)
                take_pairs<D, false, true>();
            else if (rates_.gradient)
                take_pairs<D, true, true>();
            else
                take_pairs<D, true, false>();
            weigh(D);
            if (rates_.gradient) sum_gradient<D>(e);
            if (rates_.divergence) row_sums(tile_, flow_.data(), slope_.data(), e.scale * rates_.divergence->coefficient, e.assign, e.out[target(*rates_.divergence)]);
        }
    }

private:
    const PairSet& set_;
    const PlainRates& rates_;
    const PairFields& fields_;
    PairTile tile_;
    Array r_[3], r2_, distance_, slope_;
    Array pressure_, flow_;     ///< own f_i + other f_j, of u along r_ij
    Array u_dot_r_, Pi_;

    int target(const PlainRates::Derivative& derivative) const { return set_.components.first[std::size_t(derivative.target)]; }

    void make_room() {
        const std::size_t need = std::size_t(std::max<long>(tile_.n, pairs_per_tile) + overrun);
        if (r2_.size() >= need) return;
        for (Array* array : {&r_[0], &r_[1], &r_[2], &r2_, &distance_, &slope_, &pressure_, &flow_, &u_dot_r_, &Pi_}) *array = Array(need);
    }

    /// Fields in their order: positions, velocity, pressure. Row by row in whole vectors: what one writes beyond its row the next overwrites.
    template <int D, bool velocity, bool pressure>
    void take_pairs() {
        constexpr int fields = D + (velocity ? D : 0) + pressure, first_width = fields == 3 ? 4 : std::min(fields, 4),
                      second_width = fields <= 4 ? 0 : fields == 7 ? 4 : fields - 4;
        const double *one = fields_.parts()[0].values.data(), *two = second_width ? fields_.parts()[1].values.data() : nullptr;
        const PlainRates::Derivative p = rates_.gradient.value_or(PlainRates::Derivative{}), u = rates_.divergence.value_or(PlainRates::Derivative{});
        const std::array<Period, 3> period{set_.list.period(0), set_.list.period(1), set_.list.period(2)};
        double* r_to[D];
        for (int a = 0; a < D; ++a) r_to[a] = r_[a].data();
        double *r2_to = r2_.data(), *pressure_to = pressure_.data(), *flow_to = rates_.divergence ? flow_.data() : nullptr,
               *u_dot_r_to = rates_.viscosity ? u_dot_r_.data() : nullptr;
        const std::int32_t* j = tile_.j;
        tile_.for_rows([&](long i, int first, int last) {
            double mine[8];
            for (int c = 0; c < fields; ++c) mine[c] = c < 4 ? one[first_width * i + c] : two[second_width * i + c - 4];
            for (int k = first; k < last; k += lanes) {
                Lane f[8], r2 = {}, u_dot_r = {}, flow = {};
                take<first_width>(one, j + k, f);
                if constexpr (second_width > 0) take<second_width>(two, j + k, f + 4);
#pragma GCC unroll 3
                for (int a = 0; a < D; ++a) {
                    const Lane r = period[std::size_t(a)].nearest(mine[a] - f[a]);
                    r2 += r * r;
                    if constexpr (pressure) store(r_to[a] + k, r);
                    if constexpr (velocity) {
                        u_dot_r += (mine[D + a] - f[D + a]) * r;
                        flow += (u.own * mine[D + a] + u.other * f[D + a]) * r;
                    }
                }
                store(r2_to + k, r2);
                if constexpr (pressure) store(pressure_to + k, p.own * mine[fields - 1] + p.other * f[fields - 1]);
                if (velocity && flow_to) store(flow_to + k, flow);
                if (velocity && u_dot_r_to) store(u_dot_r_to + k, u_dot_r);
            }
        });
    }

    void weigh(int dimension) {
        double *__restrict distance = distance_.data(), *__restrict r2 = r2_.data();
        for (int k = 0; k < tile_.n; ++k) distance[k] = std::sqrt(r2[k]);
        const KernelUse& use = set_.scene.kernels[std::size_t(rates_.kernel)];
        use.kernel->evaluate(dimension, tile_.n, distance, use.h, nullptr, slope_.data());
        if (!rates_.viscosity) return;
        const abi::Medium& medium = set_.scene.medium;
        rates_.viscosity->viscosity->pairs({.n = tile_.n, .u_dot_r = u_dot_r_.data(), .r2 = r2, .h = use.h, .c = medium.c0, .rho = medium.rho0}, Pi_.data());
    }

    template <int D>
    void sum_gradient(const Evaluation& e) {
        const double coefficient = rates_.gradient->coefficient, mass = set_.mass, *slope = slope_.data(), *pressure = pressure_.data(),
                     *Pi = rates_.viscosity ? Pi_.data() : nullptr;
        double* const* out = e.out + target(*rates_.gradient);
        tile_.for_rows([&](long i, int first, int last) {
            Lane sum[D] = {};
            for (int k = first; k < last; k += lanes) {
                Lane value = coefficient * load(pressure + k);
                if (Pi) value -= mass * load(Pi + k);
                value = first_lanes(value * load(slope + k), last - k);
#pragma GCC unroll 3
                for (int a = 0; a < D; ++a) sum[a] += value * first_lanes(load(r_[a].data() + k), last - k);
            }
            for (int a = 0; a < D; ++a) out[a][i] = (e.assign ? 0 : out[a][i]) + e.scale * total(sum[a]);
        });
    }
};

class PlainProgram final : public Program {
public:
    PlainProgram(const PairSet& set, const PlainRates& rates) : set_(set), rates_(rates), fields_(set, components_read(set, rates)) {
        for (int t = 0; t < set.threads; ++t) workers_.emplace_back(set, rates_, fields_);
    }

    void evaluate(const Evaluation& e) override {
        if (e.terms == Terms::dissipation_only) return;
        fields_.fill(e.state, nullptr);
        const long n = tiles(set_), threads = set_.threads;
        in_parallel(set_.threads, threads, [&](long t) {
            const long begin = n * t / threads, end = n * (t + 1) / threads;
            PlainWorker& worker = workers_[std::size_t(t)];
            switch (set_.scene.box.dimension) {
                case 1: return worker.evaluate<1>(e, begin, end);
                case 2: return worker.evaluate<2>(e, begin, end);
                default: return worker.evaluate<3>(e, begin, end);
            }
        });
    }

private:
    const PairSet& set_;
    const PlainRates rates_;
    PairFields fields_;
    std::vector<PlainWorker> workers_;
};

}    // namespace

std::unique_ptr<Program> make_plain_program(const PairSet& set, const PlainRates& rates) { return std::make_unique<PlainProgram>(set, rates); }

}    // namespace sphonic
