#include "frozen_weights.hpp"

#include <string>

#include <sphonic/error.hpp>

#include "correction.hpp"
#include "parallel.hpp"

namespace sphonic {
namespace {

using Matrix = std::array<double, 9>;

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

[[noreturn]] void refuse(const PairSet& set, long i, long neighbours) {
    std::string at;
    for (int a = 0; a < set.scene.box.dimension; ++a) at += (a ? ", " : "") + std::to_string(set.x[a][i]);
    throw Error(Fault::input, set.scene.file + ": /particles",
                "the " + std::to_string(neighbours) + " neighbours of particle " + std::to_string(i) + " at (" + at +
                    ") m do not determine a gradient, which a corrected form needs",
                "Choose a larger h, or an arrangement without isolated particles");
}

/// L_i of every particle.
std::vector<Matrix> corrections(const PairSet& set, int kernel) {
    const auto& start = set.list.start();
    const PairGeometry& pairs = *set.kept;
    const double* slope = pairs.slope[std::size_t(kernel)].data();
    std::vector<Matrix> all;
    for (long i = 0; i < set.layout.particles(); ++i) {
        Moment moment(set.scene.box.dimension);
        const std::int64_t first = start[std::size_t(i)], last = start[std::size_t(i) + 1];
        for (std::int64_t k = first; k < last; ++k) {
            double r[3] = {};
            for (int a = 0; a < set.scene.box.dimension; ++a) r[a] = pairs.r[a].data()[k];
            moment.add(r, set.volume * slope[k]);
        }
        const auto inverse = moment.inverse();
        if (!inverse) refuse(set, i, last - first);
        all.push_back(*inverse);
    }
    return all;
}

/// L w, in place.
void correct(const Matrix& L, int d, double* const* w, std::int64_t k) {
    double old[3] = {};
    for (int a = 0; a < d; ++a) old[a] = w[a][k];
    for (int a = 0; a < d; ++a) {
        w[a][k] = 0;
        for (int b = 0; b < d; ++b) w[a][k] += L[std::size_t(3 * a + b)] * old[b];
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
    std::vector<Matrix> L;
    if (correction != abi::Correction::none) L = corrections(set_, kernel);
    for (long i = 0; i < set_.layout.particles(); ++i) {
        for (std::int64_t k = start[std::size_t(i)]; k < start[std::size_t(i) + 1]; ++k) {
            for (int a = 0; a < d; ++a) own[a][i] += other[a][k];
            if (correction == abi::Correction::own) correct(L[std::size_t(i)], d, other, k);
            if (correction == abi::Correction::pairwise) correct(L[std::size_t(neighbour[std::size_t(k)])], d, other, k);
        }
        if (!L.empty()) correct(L[std::size_t(i)], d, own, i);
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
