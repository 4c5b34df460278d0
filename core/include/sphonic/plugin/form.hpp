#pragma once
/// A form plugin is a struct with own(rho_i, rho_j) and other(rho_i, rho_j), the weights of a pair's two values;
/// `static constexpr bool uniform = true` when they do not depend on the densities.

#include <sphonic/plugin/abi/form.hpp>
#include <sphonic/plugin/entry.hpp>

namespace sphonic::detail {

template <class F>
class FormAdapter final : public abi::Form {
public:
    F model;

    bool uniform() const override {
        if constexpr (requires { F::uniform; })
            return F::uniform;
        else
            return false;
    }
    void coefficients(const abi::PairMedia& media, double* __restrict own, double* __restrict other) const override {
        const double* __restrict rho_i = media.rho_i, * __restrict rho_j = media.rho_j;
#pragma omp simd
        for (int k = 0; k < media.n; ++k) {
            own[k] = model.own(rho_i[k], rho_j[k]);
            other[k] = model.other(rho_i[k], rho_j[k]);
        }
    }
};

}    // namespace sphonic::detail

#define SPHONIC_FORM(name, Struct, doc)                                                                                \
    SPHONIC_ENTRY(sphonic::abi::Form, Struct, sphonic::detail::FormAdapter<Struct>, name, doc)
