#pragma once
/// A dissipation plugin is a struct with operator()(pair), the coupling a_ij [1/s] of two particles at alpha = 1, and
/// strength(disorder), the alpha that a set needs; both are explained in abi/dissipation.hpp.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <sphonic/plugin/abi/dissipation.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

namespace sphonic {

/// What a dissipation may know of a pair.
struct DampedPair {
    double r;     ///< distance [m]
    double dW;    ///< dW/dr [m^-(d+1)]
    double V;     ///< volume of j [m^d]
    double h;     ///< smoothing length [m]
    double c;     ///< sound speed [m/s]
};

namespace detail {

template <class D>
class DissipationAdapter final : public abi::Dissipation {
public:
    D model;

    void couple(const abi::DampedPairs& pairs, double* __restrict a) const override {
        const double *__restrict r2 = pairs.r2, *__restrict slope = pairs.slope;
        const double *c = pairs.c_each ? pairs.c_each : &pairs.c, *volume = pairs.volume_each ? pairs.volume_each : &pairs.volume;
        const std::ptrdiff_t sc = pairs.c_each ? 1 : 0, sv = pairs.volume_each ? 1 : 0;
        for (int k = 0; k < pairs.n; ++k) {
            const double r = std::sqrt(r2[k]);
            a[k] = model(DampedPair{r, slope[k] * r, volume[k * sv], pairs.h, c[k * sc]});
        }
    }
    double strength(double disorder) const override { return model.strength(disorder); }
};

}    // namespace detail
}    // namespace sphonic

#define SPHONIC_DISSIPATION(name, Struct, doc)                                                                         \
    SPHONIC_ENTRY(sphonic::abi::Dissipation, Struct, sphonic::detail::DissipationAdapter<Struct>, name, doc)
