#include "frozen_weights.hpp"

#include <optional>

#include "pair_correction.hpp"
#include "parallel.hpp"

namespace sphonic {
namespace {

using Vector = std::array<double, 3>;

Vector corrected(const std::optional<PairCorrections>& L, long j, int d, const Vector& g) {
    if (!L) return g;
    Vector v{};
    for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) v[std::size_t(a)] += L->entry(a, b)[j] * g[std::size_t(b)];
    return v;
}

}    // namespace

const FrozenWeights& FrozenWeightStore::of(int kernel, abi::Correction correction) {
    const std::string key = std::to_string(kernel) + " " + std::to_string(int(correction));
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    return known_.emplace(key, weigh(kernel, correction, {{1, 1}})).first->second;
}

const FrozenWeights& FrozenWeightStore::of(const Term& term) {
    const bool fitted = !term.fitted.empty();
    if (!fitted && !holds_coefficients(term)) return of(term.kernel, term.form->correction());
    const bool gradient = term.op == Term::Operator::gradient;
    const std::string key = (fitted ? "fitted " : std::to_string(term.kernel) + (gradient ? " gradient " : " divergence ")) + term.form_text;
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    if (fitted) return known_.emplace(key, sum_rows(cloud_.of(term))).first->second;
    std::vector<RestCoefficients> between;
    for (const abi::Medium& i : set_.media.list())
        for (const abi::Medium& j : set_.media.list()) between.push_back(rest_coefficients(*term.form, derivative(term), i, j));
    return known_.emplace(key, weigh(term.kernel, term.form->correction(), between)).first->second;
}

FrozenWeights FrozenWeightStore::sum_rows(const CloudWeights& fitted) const {
    const auto& start = set_.list.start();
    FrozenWeights w;
    for (int a = 0; a < set_.scene.box.dimension; ++a) {
        w.own[a] = Array(std::size_t(set_.layout.size));
        w.other[a] = Array(fitted.damping.size());
    }
    in_blocks(set_.threads, set_.layout.particles(), [&](long begin, long end) {
        for (long i = begin; i < end; ++i)
            for (std::int64_t k = start[std::size_t(i)]; k < start[std::size_t(i) + 1]; ++k)
                for (int a = 0; a < set_.scene.box.dimension; ++a) w.own[a].data()[i] += w.other[a].data()[k] = fitted.gradient[a].data()[k];
    });
    w.runs = runs_of_rows(set_.list, set_.layout.particles(), w.own, w.other);
    return w;
}

/// `between`: coefficients by own and other's medium, or one for all.
FrozenWeights FrozenWeightStore::weigh(int kernel, abi::Correction correction, const std::vector<RestCoefficients>& between) const {
    const int d = set_.scene.box.dimension, media = between.size() > 1 ? set_.media.count() : 0;
    const PairGeometry& pairs = *set_.kept;
    FrozenWeights w;
    for (int a = 0; a < d; ++a) {
        w.own[a] = Array(std::size_t(set_.layout.size));
        w.other[a] = Array(pairs.r2.size());
    }
    std::optional<PairCorrections> L;
    if (correction != abi::Correction::none) L.emplace(set_, kernel).compute(nullptr);
    const auto add_pair = [&](long i, std::int64_t k) {
        const long j = set_.list.neighbour()[std::size_t(k)];
        const RestCoefficients c = between[std::size_t(media ? set_.medium(i) * media + set_.medium(j) : 0)];
        Vector g{};
        for (int a = 0; a < d; ++a) g[std::size_t(a)] = set_.volume * pairs.slope[std::size_t(kernel)].data()[k] * pairs.r[a].data()[k];
        const Vector own = corrected(L, i, d, g), other = correction == abi::Correction::pairwise ? corrected(L, j, d, g) : own;
        for (int a = 0; a < d; ++a) {
            w.own[a].data()[i] += c.own * own[std::size_t(a)];
            w.other[a].data()[k] = c.other * other[std::size_t(a)];
        }
    };
    const auto& start = set_.list.start();
    in_blocks(set_.threads, set_.layout.particles(), [&](long begin, long end) {
        for (long i = begin; i < end; ++i)
            for (std::int64_t k = start[std::size_t(i)]; k < start[std::size_t(i) + 1]; ++k) add_pair(i, k);
    });
    w.runs = runs_of_rows(set_.list, set_.layout.particles(), w.own, w.other);
    return w;
}

double FrozenWeightStore::bytes() const {
    double total = cloud_.bytes();
    for (const auto& [key, w] : known_)
        for (int a = 0; a < 3; ++a) total += 8.0 * double(w.own[a].size() + w.other[a].size());
    for (const auto& [key, a] : couplings_) total += 8.0 * double(a.size());
    for (const auto& [kernel, q] : separations_) total += 8.0 * double(q.size());
    return total;
}

}    // namespace sphonic
