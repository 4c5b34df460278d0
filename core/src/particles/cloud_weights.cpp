#include "cloud_weights.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <sphonic/error.hpp>
#include <sphonic/log.hpp>

#include "parallel.hpp"

namespace sphonic {
namespace {

/// Fits the weights of one particle after another.
class Fitting {
public:
    Fitting(const PairSet& set, const Term& term, CloudWeights& weights)
        : set_(set), weights_(weights), d_(set.scene.box.dimension), reach_(term.form->cloud_reach(d_)), fit_(term.form->cloud_fit(d_, term.cancelled)) {}

    /// False if the neighbours of particle i determine no weights.
    bool fit(long i) {
        choose(i);
        abi::CloudNeighbours neighbours{.n = int(pair_.size())};
        abi::CloudWeights found;
        for (int a = 0; a < d_; ++a) {
            neighbours.offset[a] = offset_[a].data();
            gradient_[a].resize(pair_.size());
            found.gradient[a] = gradient_[a].data();
        }
        damping_.resize(pair_.size());
        found.damping = damping_.data();
        if (neighbours.n <= d_ || !fit_->fit(neighbours, found)) return false;
        take_up(i);
        return true;
    }
    double most() const { return most_; }

private:
    const PairSet& set_;
    CloudWeights& weights_;
    int d_;
    double reach_, most_ = 0;
    std::unique_ptr<abi::CloudFit> fit_;
    std::vector<std::int64_t> pair_;    ///< those within reach
    std::vector<double> offset_[3], gradient_[3], damping_;

    void choose(long i) {
        const double dx = set_.scene.box.dx, most = std::pow(reach_ * dx, 2);
        pair_.clear();
        for (auto& offset : offset_) offset.clear();
        for (std::int64_t k = set_.list.start()[std::size_t(i)]; k < set_.list.start()[std::size_t(i) + 1]; ++k) {
            if (set_.kept->r2.data()[k] > most) continue;
            pair_.push_back(k);
            for (int a = 0; a < d_; ++a) offset_[a].push_back(-set_.kept->r[a].data()[k] / dx);
        }
    }

    void take_up(long i) {
        const double dx = set_.scene.box.dx, c0 = set_.scene.medium.c0;
        double sum = 0, size = 0;
        for (std::size_t n = 0; n < pair_.size(); ++n) {
            for (int a = 0; a < d_; ++a) weights_.gradient[a].data()[pair_[n]] = gradient_[a][n] / dx;
            const double d = weights_.damping.data()[pair_[n]] = damping_[n] * c0 / dx;
            sum += d;
            size += std::abs(d);
        }
        weights_.drained.data()[i] = sum;
        most_ = std::max(most_, std::abs(sum) + size);    // Gershgorin's bound
    }
};

/// Says every five seconds how far a long fit has come.
class Patience {
public:
    void at(long done, long all) {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < std::chrono::seconds(5)) return;
        last_ = now;
        log::info("fitting the weights of each particle: " + std::to_string(100 * done / all) + " %");
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

CloudWeights fit_all(const PairSet& set, const Term& term) {
    const std::size_t pairs = set.kept->r2.size();
    CloudWeights weights;
    for (int a = 0; a < set.scene.box.dimension; ++a) weights.gradient[a] = Array(pairs);
    weights.damping = Array(pairs);
    weights.drained = Array(std::size_t(set.layout.size));
    const long n = set.layout.particles(), shares = set.threads;
    std::vector<double> most(std::size_t(shares), 0.0);
    std::vector<long> degenerate(std::size_t(shares), -1);
    in_parallel(set.threads, shares, [&](long share) {
        Fitting fitting(set, term, weights);
        Patience patience;
        const long first = n * share / shares, end = n * (share + 1) / shares;
        for (long i = first; i < end && degenerate[std::size_t(share)] < 0; ++i) {
            if (!fitting.fit(i)) degenerate[std::size_t(share)] = i;
            if (share == 0 && i % 256 == 0) patience.at(i - first, end - first);
        }
        most[std::size_t(share)] = fitting.most();
    });
    for (const long i : degenerate)
        if (i >= 0)
            throw Error(Fault::input, set.scene.file + ": /particles", "the neighbours of particle " + std::to_string(i) + " determine no weights for the form " +
                        term.form_text, "Choose an arrangement without isolated or coinciding particles, or another form");
    weights.most = *std::max_element(most.begin(), most.end());
    return weights;
}

}    // namespace

const CloudWeights& CloudWeightStore::of(const Term& term) {
    if (const auto known = known_.find(term.form_text); known != known_.end()) return known->second;
    return known_.emplace(term.form_text, fit_all(set_, term)).first->second;
}

double CloudWeightStore::damping() const {
    double most = 0;
    for (const auto& [key, w] : known_) most = std::max(most, w.most);
    return most;
}

double CloudWeightStore::bytes() const {
    double total = 0;
    for (const auto& [key, w] : known_) {
        total += 8.0 * double(w.damping.size() + w.drained.size());
        for (const Array& g : w.gradient) total += 8.0 * double(g.size());
    }
    return total;
}

void CloudDamping::apply(const Evaluation& e, long begin, long end) const {
    const std::int32_t* __restrict j = set_.list.neighbour().data();
    const double* __restrict d = weights_.damping.data();
    for (const int c : components_) {
        const double* __restrict f = e.state[c];
        for (long i = begin; i < end; ++i) {
            const std::int64_t first = set_.list.start()[std::size_t(i)], last = set_.list.start()[std::size_t(i) + 1];
            double sum = -weights_.drained.data()[i] * f[i];
#pragma omp simd reduction(+ : sum)
            for (std::int64_t k = first; k < last; ++k) sum += d[k] * f[j[k]];
            e.out[c][i] += e.scale * sum;
        }
    }
}

}    // namespace sphonic
