#include "frozen_weights.hpp"

#include <optional>

#include "pair_correction.hpp"

namespace sphonic {
namespace {

/// V_j grad_i W_ij of every pair.
FrozenWeights plain_weights(const PairSet& set, int kernel) {
    const int d = set.scene.box.dimension;
    const PairGeometry& pairs = *set.kept;
    const double* __restrict slope = pairs.slope[std::size_t(kernel)].data();
    FrozenWeights w;
    for (int a = 0; a < d; ++a) {
        w.own[a] = Array(std::size_t(set.layout.size));
        w.other[a] = Array(pairs.r2.size());
        double* __restrict other = w.other[a].data();
        const double* __restrict r = pairs.r[a].data();
        for (std::size_t k = 0; k < pairs.r2.size(); ++k) other[k] = set.volume * slope[k] * r[k];
    }
    return w;
}

/// w_k becomes L_j w_k.
void correct(const PairCorrections& L, long j, int d, double* const* w, std::int64_t k) {
    double old[3] = {};
    for (int a = 0; a < d; ++a) old[a] = w[a][k];
    for (int a = 0; a < d; ++a) {
        w[a][k] = 0;
        for (int b = 0; b < d; ++b) w[a][k] += L.entry(a, b)[j] * old[b];
    }
}

}    // namespace

const FrozenWeights& FrozenWeightStore::of(int kernel, abi::Correction correction) {
    if (const auto known = known_.find({kernel, correction}); known != known_.end()) return known->second;
    FrozenWeights w = plain_weights(set_, kernel);
    const int d = set_.scene.box.dimension;
    double* own[3] = {w.own[0].data(), w.own[1].data(), w.own[2].data()};
    double* other[3] = {w.other[0].data(), w.other[1].data(), w.other[2].data()};
    const auto& start = set_.list.start();
    const auto& neighbour = set_.list.neighbour();
    std::optional<PairCorrections> L;
    if (correction != abi::Correction::none) L.emplace(set_, kernel).compute(nullptr);
    for (long i = 0; i < set_.layout.particles(); ++i) {
        for (std::int64_t k = start[std::size_t(i)]; k < start[std::size_t(i) + 1]; ++k) {
            for (int a = 0; a < d; ++a) own[a][i] += other[a][k];
            if (L) correct(*L, correction == abi::Correction::own ? i : neighbour[std::size_t(k)], d, other, k);
        }
        if (L) correct(*L, i, d, own, i);
    }
    return known_.emplace(std::pair{kernel, correction}, std::move(w)).first->second;
}

double FrozenWeightStore::bytes() const {
    double total = 0;
    for (const auto& [key, w] : known_)
        for (int a = 0; a < 3; ++a) total += 8.0 * double(w.own[a].size() + w.other[a].size());
    return total;
}

}    // namespace sphonic
