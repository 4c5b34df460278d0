#include <algorithm>
#include <cmath>

#include "parallel.hpp"
#include "plain_pairs.hpp"
#include "plain_values.hpp"

namespace sphonic {
namespace {

/// Tiles of pairs, for one thread.
class PlainWorker {
public:
    PlainWorker(const PairSet& set, const PlainRates& rates, const PairFields& fields) : set_(set), rates_(rates), values_(set, rates, fields) {}

    /// `inverse_rho` of all particles, or null at rest.
    template <int D>
    void evaluate(const Evaluation& e, const double* inverse_rho, long begin, long end) {
        for (long t = begin; t < end; ++t) {
            take_tile(set_, t, tile_);
            values_.take<D>(tile_);
            values_.weigh(D);
            if (rates_.gradient) sum_gradient<D>(e, inverse_rho);
            if (rates_.divergence) sum_divergence(e, inverse_rho);
        }
    }

private:
    const PairSet& set_;
    const PlainRates& rates_;
    PlainValues values_;
    PairTile tile_;

    /// coefficient rho_i^power
    double coefficient(const PlainRates::Derivative& derivative, const Evaluation& e, const double* inverse_rho, long i) const {
        double c = derivative.coefficient;
        const double* rho = derivative.density_power > 0 ? e.state[set_.components.first[std::size_t(rates_.density)]] : inverse_rho;
        for (int p = 0; p < std::abs(derivative.density_power); ++p) c *= rho[i];
        return c;
    }

    template <int D>
    void sum_gradient(const Evaluation& e, const double* inverse_rho) {
        const double mass = set_.mass, *slope = values_.slope(), *weight = values_.weight(), *pressure = values_.pressure(), *Pi = values_.Pi();
        double* const* out = e.out + set_.components.first[std::size_t(rates_.gradient->target)];
        tile_.for_rows([&](long i, int first, int last) {
            const double c = coefficient(*rates_.gradient, e, inverse_rho, i);
            Lane sum[D] = {};
            for (int k = first; k < last; k += lanes) {
                Lane value = c * load(pressure + k) * load(weight + k);
                if (Pi) value -= mass * load(Pi + k) * load(slope + k);
                value = first_lanes(value, last - k);
#pragma GCC unroll 3
                for (int a = 0; a < D; ++a) sum[a] += value * first_lanes(load(values_.r(a) + k), last - k);
            }
            for (int a = 0; a < D; ++a) out[a][i] = (e.assign ? 0 : out[a][i]) + e.scale * total(sum[a]);
        });
    }

    void sum_divergence(const Evaluation& e, const double* inverse_rho) {
        const double *weight = values_.weight(), *flow = values_.flow();
        double* out = e.out[set_.components.first[std::size_t(rates_.divergence->target)]];
        tile_.for_rows([&](long i, int first, int last) {
            const double sum = sum_of(first, last, [&](int k) { return load(flow + k) * load(weight + k); });
            out[i] = (e.assign ? 0 : out[i]) + e.scale * coefficient(*rates_.divergence, e, inverse_rho, i) * sum;
        });
    }
};

class PlainProgram final : public Program {
public:
    PlainProgram(const PairSet& set, const PlainRates& rates) : set_(set), rates_(rates), fields_(set, rates.components_read(set)) {
        for (int t = 0; t < set.threads; ++t) workers_.emplace_back(set, rates_, fields_);
        if (rates_.density >= 0) inverse_rho_ = Array(std::size_t(set.layout.size));
    }

    void evaluate(const Evaluation& e) override {
        if (e.terms == Terms::dissipation_only) return;
        if (rates_.density >= 0) invert(set_.threads, set_.layout.size, e.state[set_.components.first[std::size_t(rates_.density)]], inverse_rho_.data());
        fields_.fill(e.state, inverse_rho_.data());
        const long n = tiles(set_), threads = set_.threads;
        in_parallel(set_.threads, threads, [&](long t) {
            const long begin = n * t / threads, end = n * (t + 1) / threads;
            PlainWorker& worker = workers_[std::size_t(t)];
            switch (set_.scene.box.dimension) {
                case 1: return worker.evaluate<1>(e, inverse_rho_.data(), begin, end);
                case 2: return worker.evaluate<2>(e, inverse_rho_.data(), begin, end);
                default: return worker.evaluate<3>(e, inverse_rho_.data(), begin, end);
            }
        });
    }

private:
    const PairSet& set_;
    const PlainRates rates_;
    PairFields fields_;
    std::vector<PlainWorker> workers_;
    Array inverse_rho_;
};

}    // namespace

std::unique_ptr<Program> make_plain_program(const PairSet& set, const PlainRates& rates) { return std::make_unique<PlainProgram>(set, rates); }

}    // namespace sphonic
