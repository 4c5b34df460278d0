#pragma once
#include <map>
#include <memory>
#include <string>

#include "pair_set.hpp"

namespace sphonic {

/// Weights that a form has fitted to each neighbourhood of a cloud, of the differences f_j - f_i of all pairs; zero beyond its reach.
struct CloudWeights {
    Array gradient[3];    ///< by axis and pair [1/m]
    Array damping;        ///< by pair [1/s]: df_i/dt += sum_j d_ij (f_j - f_i)
    Array drained;        ///< sum_j d_ij, by particle [1/s]
    double most = 0;      ///< no rate of that damping is larger [1/s]
};

/// Those of all forms in use on a frozen set, each fitted once.
class CloudWeightStore {
public:
    explicit CloudWeightStore(const PairSet& set) : set_(set) {}
    /// Throws if some particle's neighbours determine no weights.
    const CloudWeights& of(const Term& term);
    /// The largest rate of damping [1/s].
    double damping() const;
    double bytes() const;

private:
    const PairSet& set_;
    std::map<std::string, CloudWeights> known_;
};

/// The damping that the weights of a variable's terms ask for, added to the rate of each of its components.
class CloudDamping {
public:
    CloudDamping(const PairSet& set, const CloudWeights& weights, std::vector<int> components)
        : set_(set), weights_(weights), components_(std::move(components)) {}
    /// For particles begin ... end - 1.
    void apply(const Evaluation& evaluation, long begin, long end) const;

private:
    const PairSet& set_;
    const CloudWeights& weights_;
    std::vector<int> components_;
};

}    // namespace sphonic
