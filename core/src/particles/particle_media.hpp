#pragma once
#include <vector>

#include <sphonic/case.hpp>

namespace sphonic {

/// The medium of each particle of a set.
class ParticleMedia {
public:
    /// `x` by axis, of n particles as they begin.
    ParticleMedia(const Case& scene, long n, const double* const* x) : list_(scene.media->list()) {
        if (!several()) return;
        number_.resize(std::size_t(n));
        abi::Points points{.dimension = scene.box.dimension, .n = int(n)};
        for (int a = 0; a < scene.box.dimension; ++a) points.x[a] = x[a];
        scene.media->find(points, number_.data());
    }

    bool several() const { return list_.size() > 1; }
    int count() const { return int(list_.size()); }
    int number(long i) const { return several() ? number_[std::size_t(i)] : 0; }
    const abi::Medium& of(long i) const { return list_[std::size_t(number(i))]; }
    const std::vector<abi::Medium>& list() const { return list_; }

private:
    const std::vector<abi::Medium>& list_;
    std::vector<int> number_;    ///< empty where there is one medium only
};

/// K = rho0 c0^2 [Pa].
inline double bulk_modulus(const abi::Medium& m) { return m.rho0 * m.c0 * m.c0; }

}    // namespace sphonic
