#include "pair_dissipation.hpp"

#include <numeric>

#include "parallel.hpp"

namespace sphonic {
namespace {

std::vector<int> count_to(int n) {
    std::vector<int> all(std::size_t(n), 0);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

}    // namespace

PairDissipation::PairDissipation(const PairSet& set, const Term& term, const PairCorrections& corrections)
    : set_(set), term_(term), corrections_(corrections), first_(set.components.first[std::size_t(term.operand)]),
      components_(set.scene.equations.variables[std::size_t(term.operand)].components(set.scene.box.dimension)),
      fields_(set, count_to(components_)), all_(set, count_to(components_ * (1 + set.scene.box.dimension))) {
    for (int t = 0; t < set.threads; ++t) workers_.push_back({PairValues(set, fields_), PairValues(set, all_)});
}

/// Calls visit(worker) with each tile.
void PairDissipation::for_tiles(auto visit) {
    const long n = tiles(set_), threads = set_.threads;
    in_parallel(set_.threads, threads, [&](long t) {
        Worker& worker = workers_[std::size_t(t)];
        for (long k = n * t / threads; k < n * (t + 1) / threads; ++k) {
            take_tile(set_, k, worker.tile);
            visit(worker);
        }
    });
}

void PairDissipation::apply(const Evaluation& e, const double* inverse_rho) {
    while (int(gradient_.size()) < components_ * set_.scene.box.dimension) gradient_.emplace_back(std::size_t(set_.layout.size));
    state_.assign(e.state + first_, e.state + first_ + components_);
    for (const Array& gradient : gradient_) state_.push_back(gradient.data());
    fields_.fill(state_.data(), inverse_rho);
    for_tiles([&](Worker& worker) { take_gradients(worker); });
    for (int c = 0; c < components_; ++c)
        for (int a = 0; a < set_.scene.box.dimension; ++a) set_.mirrors.fill_derivative(first_ + c, a, gradient_[std::size_t(at(c, a))].data());
    all_.fill(state_.data(), inverse_rho);
    for_tiles([&](Worker& worker) { add_sums(worker, e, inverse_rho); });
}

void PairDissipation::take_gradients(Worker& worker) {
    PairValues& pairs = worker.values;
    pairs.start(worker.tile);
    worker.corrected.start(set_, corrections_, worker.tile, pairs);
    double* __restrict value = pairs.room(worker.pair);
    for (int c = 0; c < components_; ++c)
        for (int a = 0; a < set_.scene.box.dimension; ++a) {
            const double *__restrict fi = pairs.own(c), *__restrict fj = pairs.other(c), *__restrict r = worker.corrected.own(a);
            for (int k = 0; k < pairs.n(); ++k) value[k] = (fj[k] - fi[k]) * r[k];
            row_sums(worker.tile, value, pairs.weight(term_.kernel), 1, true, gradient_[std::size_t(at(c, a))].data());
        }
}

/// sum_j a_ij [ f_j - f_i + (g_i + g_j)/2 . r_ij ]
void PairDissipation::add_sums(Worker& worker, const Evaluation& e, bool current_density) {
    PairValues& pairs = worker.all;
    pairs.start(worker.tile);
    const double* coupling = couplings(worker, current_density);
    double* __restrict value = pairs.room(worker.pair);
    for (int c = 0; c < components_; ++c) {
        const double *__restrict fi = pairs.own(c), *__restrict fj = pairs.other(c);
        for (int k = 0; k < pairs.n(); ++k) value[k] = fj[k] - fi[k];
        for (int a = 0; a < set_.scene.box.dimension; ++a) {
            const int g = components_ + at(c, a);
            const double *__restrict gi = pairs.own(g), *__restrict gj = pairs.other(g), *__restrict r = pairs.r(a);
            for (int k = 0; k < pairs.n(); ++k) value[k] += 0.5 * (gi[k] + gj[k]) * r[k];
        }
        row_sums(worker.tile, value, coupling, e.scale * term_.coefficient[0], false, e.out[first_ + c]);
    }
}

const double* PairDissipation::couplings(Worker& worker, bool current_density) {
    PairValues& pairs = worker.all;
    abi::DampedPairs block{.n = pairs.n(), .r2 = pairs.r2(), .slope = pairs.slope(term_.kernel), .h = set_.scene.kernels[std::size_t(term_.kernel)].h,
                           .c = set_.scene.medium.c0, .volume = set_.volume};
    if (current_density) {
        double* __restrict volume = pairs.room(worker.volume);
        const double* __restrict inverse = pairs.other_inverse_rho();
        for (int k = 0; k < pairs.n(); ++k) volume[k] = set_.mass * inverse[k];
        block.volume_each = volume;
    }
    double* a = pairs.room(worker.coupling);
    term_.dissipation->couple(block, a);
    return a;
}

}    // namespace sphonic
