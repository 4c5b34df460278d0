#include "frozen_dissipation.hpp"

#include "parallel.hpp"

namespace sphonic {

const Array& FrozenWeightStore::of(const abi::Dissipation& dissipation, int kernel) {
    const std::pair key{&dissipation, kernel};
    if (const auto known = couplings_.find(key); known != couplings_.end()) return known->second;
    const PairGeometry& pairs = *set_.kept;
    const long n = long(set_.list.neighbour().size());
    Array a(pairs.r2.size());
    in_blocks(set_.threads, n, [&](long begin, long end) {
        dissipation.couple({.n = int(end - begin), .r2 = pairs.r2.data() + begin, .slope = pairs.slope[std::size_t(kernel)].data() + begin,
                            .h = set_.scene.kernels[std::size_t(kernel)].h, .c = set_.scene.medium.c0, .volume = set_.volume}, a.data() + begin);
    });
    if (set_.media.several()) couple_by_medium(a);
    return couplings_.emplace(key, std::move(a)).first->second;
}

/// In proportion to each medium's c0. Not between two, where gradients jump.
void FrozenWeightStore::couple_by_medium(Array& a) const {
    const auto& start = set_.list.start();
    in_blocks(set_.threads, set_.layout.particles(), [&](long begin, long end) {
        for (long i = begin; i < end; ++i)
            for (std::int64_t k = start[std::size_t(i)]; k < start[std::size_t(i) + 1]; ++k) {
                const bool same = set_.medium(i) == set_.medium(set_.list.neighbour()[std::size_t(k)]);
                a.data()[k] *= same ? set_.media.of(i).c0 / set_.scene.medium.c0 : 0;
            }
    });
}

FrozenDissipation::FrozenDissipation(const PairSet& set, FrozenWeightStore& weights, const Term& term)
    : set_(set), weights_(weights.of(term.kernel, abi::Correction::own)), coupling_(weights.of(*term.dissipation, term.kernel).data()),
      strength_(term.coefficient[0]), first_(set.components.first[std::size_t(term.operand)]),
      components_(set.scene.equations.variables[std::size_t(term.operand)].components(set.scene.box.dimension)) {}

void FrozenDissipation::apply(const Evaluation& e) {
    const int d = set_.scene.box.dimension;
    for (int a = 0; a < d; ++a)
        while (int(gradient_[a].size()) < components_) gradient_[a].emplace_back(std::size_t(set_.layout.size));
    in_blocks(set_.threads, set_.layout.particles(), [&](long begin, long end) { gradients(e, begin, end); });
    for (int a = 0; a < d; ++a)
        for (int c = 0; c < components_; ++c) set_.mirrors.fill_derivative(first_ + c, a, gradient_[a][std::size_t(c)].data());
    in_blocks(set_.threads, set_.layout.particles(), [&](long begin, long end) { sums(e, begin, end); });
}

void FrozenDissipation::gradients(const Evaluation& e, long begin, long end) {
    switch (set_.scene.box.dimension) {
        case 1: return gradients_in<1>(e, begin, end);
        case 2: return gradients_in<2>(e, begin, end);
        default: return gradients_in<3>(e, begin, end);
    }
}

void FrozenDissipation::sums(const Evaluation& e, long begin, long end) const {
    switch (set_.scene.box.dimension) {
        case 1: return sums_in<1>(e, begin, end);
        case 2: return sums_in<2>(e, begin, end);
        default: return sums_in<3>(e, begin, end);
    }
}

/// Component by component within a row, whose weights then stay in the first-level cache. Without SIMD, whose gathered loads take
/// twice as long here and below.
template <int D>
void FrozenDissipation::gradients_in(const Evaluation& e, long begin, long end) {
    const std::int64_t* start = set_.list.start().data();
    const std::int32_t* j = set_.list.neighbour().data();
    const double* weight[3] = {weights_.other[0].data(), weights_.other[1].data(), weights_.other[2].data()};
    for (long i = begin; i < end; ++i)
        for (int c = 0; c < components_; ++c) {
            const double* f = e.state[first_ + c];
            double sum[D] = {};
            for (std::int64_t k = start[i]; k < start[i + 1]; ++k) {
                const double jump = f[j[k]] - f[i];
                for (int a = 0; a < D; ++a) sum[a] += weight[a][k] * jump;
            }
            for (int a = 0; a < D; ++a) gradient_[a][std::size_t(c)].data()[i] = sum[a];
        }
}

/// sum_j a_ij [ f_j - f_i + (g_i + g_j)/2 . r_ij ]
template <int D>
void FrozenDissipation::sums_in(const Evaluation& e, long begin, long end) const {
    const std::int64_t* start = set_.list.start().data();
    const std::int32_t* j = set_.list.neighbour().data();
    const double* r[3] = {set_.kept->r[0].data(), set_.kept->r[1].data(), set_.kept->r[2].data()};
    const double* g[3][3] = {};    // by component and axis
    for (int c = 0; c < components_; ++c)
        for (int a = 0; a < D; ++a) g[c][a] = gradient_[a][std::size_t(c)].data();
    for (long i = begin; i < end; ++i)
        for (int c = 0; c < components_; ++c) {
            const double* f = e.state[first_ + c];
            double sum = 0;
            for (std::int64_t k = start[i]; k < start[i + 1]; ++k) {
                double linear = 0;
                for (int a = 0; a < D; ++a) linear += (g[c][a][i] + g[c][a][j[k]]) * r[a][k];
                sum += coupling_[k] * (f[j[k]] - f[i] + 0.5 * linear);
            }
            e.out[first_ + c][i] += e.scale * strength_ * sum;
        }
}

}    // namespace sphonic
