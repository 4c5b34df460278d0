#pragma once
/// A form plugin is a struct with own(i, j) and other(i, j), the weights of a pair's two values, where i and j are the
/// two sides' densities; `static constexpr bool uniform = true` when the weights do not depend on them.

#include <sphonic/plugin/abi/form.hpp>
#include <sphonic/plugin/entry.hpp>

namespace sphonic {

/// What a form may know of one particle of a pair.
struct PairSide {
    double rho, inverse_rho;
};

namespace detail {

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
        const double *__restrict rho_i = media.rho_i, *__restrict rho_j = media.rho_j;
        const double *__restrict inverse_i = media.inverse_rho_i, *__restrict inverse_j = media.inverse_rho_j;
        for (int k = 0; k < media.n; ++k) {
            const PairSide i{rho_i[k], inverse_i[k]}, j{rho_j[k], inverse_j[k]};
            own[k] = model.own(i, j);
            other[k] = model.other(i, j);
        }
    }
};

}    // namespace detail
}    // namespace sphonic

#define SPHONIC_FORM(name, Struct, doc)                                                                                \
    SPHONIC_ENTRY(sphonic::abi::Form, Struct, sphonic::detail::FormAdapter<Struct>, name, doc)
