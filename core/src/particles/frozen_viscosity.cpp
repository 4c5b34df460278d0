#include "frozen_viscosity.hpp"

#include <algorithm>

#include "parallel.hpp"

namespace sphonic {

const Array& FrozenWeightStore::separations(int kernel) {
    Array& q = separations_[kernel];
    if (q.data()) return q;
    const Array& slope = set_.kept->slope[std::size_t(kernel)];
    q = Array(slope.size());
    for (std::size_t k = 0; k < slope.size(); ++k) q.data()[k] = slope.data()[k] == 0 ? 0 : 1 / (set_.volume * slope.data()[k]);
    return q;
}

FrozenViscosity::FrozenViscosity(const PairSet& set, FrozenWeightStore& weights, const Term& term, std::vector<int> target)
    : set_(set), term_(term), weights_(weights.of(term.kernel, abi::Correction::none)), separation_(weights.separations(term.kernel).data()),
      target_(std::move(target)), velocity_(set.components.first[std::size_t(term.operand)]) {}

void FrozenViscosity::fill(const Evaluation& e) {
    const int d = set_.scene.box.dimension;
    const long n = set_.layout.size;
    velocities_.resize(d, n);
    in_blocks(set_.threads, n, [&](long begin, long end) { velocities_.fill(e.state + velocity_, d, begin, end); });
}

void FrozenViscosity::apply(const Evaluation& e, long begin, long end) const {
    switch (set_.scene.box.dimension) {
        case 1: return apply_in<1>(e, begin, end);
        case 2: return apply_in<2>(e, begin, end);
        default: return apply_in<3>(e, begin, end);
    }
}

template <int D>
void FrozenViscosity::apply_in(const Evaluation& e, long begin, long end) const {
    const std::int64_t* start = set_.list.start().data();
    while (begin < end) {
        long last = begin + 1;
        while (last < end && start[last + 1] - start[begin] <= most_pairs) ++last;
        apply_tile<D>(e, begin, last);
        begin = last;
    }
}

template <int D>
void FrozenViscosity::apply_tile(const Evaluation& e, long begin, long end) const {
    constexpr int width = D == 3 ? 4 : D;
    const std::int64_t *start = set_.list.start().data(), base = start[begin];
    const std::int32_t* j = set_.list.neighbour().data();
    const long n = start[end] - base, room = std::max(n, most_pairs) + overrun;
    double local[3 * (most_pairs + overrun)];
    std::vector<double> large(n > most_pairs ? std::size_t(3 * room) : 0);    // one particle with as many neighbours
    double *u_dot_r = large.empty() ? local : large.data(), *Pi = u_dot_r + room, *r2 = Pi + room;
    const double *w[D], *u = velocities_.values.data();
    for (int a = 0; a < D; ++a) w[a] = weights_.other[a].data();
    const double h = set_.scene.kernels[std::size_t(term_.kernel)].h;
    const Lane least = 1e-6 * h * h - Lane{};    // pairs without a weight have no separation either
    for (long i = begin; i < end; ++i)
        for (std::int64_t k = start[i]; k < start[i + 1]; k += lanes) {
            Lane u_j[width], flow = {}, length2 = {};
            take<width>(u, j + k, u_j);
            const Lane q = load(separation_ + k);
            for (int a = 0; a < D; ++a) {
                const Lane r = q * load(w[a] + k);
                flow += (u[width * i + a] - u_j[a]) * r;
                length2 += r * r;
            }
            store(u_dot_r + (k - base), flow);
            store(r2 + (k - base), length2 > least ? length2 : least);
        }
    const abi::Medium& medium = set_.scene.medium;
    term_.viscosity->pairs({.n = int(n), .u_dot_r = u_dot_r, .r2 = r2, .h = h, .c = medium.c0, .rho = medium.rho0}, Pi);
    const double scale = -e.scale * set_.mass / set_.volume;
    for (long i = begin; i < end; ++i) {
        Lane sum[D] = {};
        for (std::int64_t k = start[i]; k < start[i + 1]; k += lanes) {
            const int left = int(std::min<std::int64_t>(lanes, start[i + 1] - k));
            const Lane value = first_lanes(load(Pi + (k - base)), left);
            for (int a = 0; a < D; ++a) sum[a] += value * first_lanes(load(w[a] + k), left);
        }
        for (int a = 0; a < D; ++a) e.out[target_[std::size_t(a)]][i] += scale * total(sum[a]);
    }
}

}    // namespace sphonic
