#pragma once
/// A form plugin is a struct with own(i, j) and other(i, j), the weights of a pair's two values, where i and j are the
/// two sides' media; a form that treats gradient and divergence differently takes the abi::Derivative as third argument.
/// `static constexpr bool uniform = true` when the weights do not depend on the media, and
/// `static constexpr abi::Correction correction` where the kernel's gradient is corrected. A form with weights of its own has
/// reach() and fit(lattice, weights) besides, and where it has them on clouds, cloud_reach(dimension) and cloud_fit(dimension, courant).

#include <sphonic/plugin/abi/form.hpp>
#include <sphonic/plugin/entry.hpp>

namespace sphonic {

/// What a form may know of one particle of a pair.
struct PairSide {
    double rho, inverse_rho, impedance;
};

namespace detail {

template <class F>
class FormAdapter final : public abi::Form {
public:
    F model;

    abi::Correction correction() const override {
        if constexpr (requires { F::correction; })
            return F::correction;
        else
            return abi::Correction::none;
    }
    double reach() const override {
        if constexpr (requires { model.reach(); })
            return model.reach();
        else
            return 0;
    }
    void fit(const abi::LatticeFit& lattice, double* weight) const override {
        if constexpr (requires { model.fit(lattice, weight); }) model.fit(lattice, weight);
    }
    double cloud_reach(int dimension) const override {
        if constexpr (requires { model.cloud_reach(dimension); })
            return model.cloud_reach(dimension);
        else
            return 0;
    }
    std::unique_ptr<abi::CloudFit> cloud_fit(int dimension, double courant) const override {
        if constexpr (requires { model.cloud_fit(dimension, courant); })
            return model.cloud_fit(dimension, courant);
        else
            return nullptr;
    }
    bool uniform() const override {
        if constexpr (requires { F::uniform; })
            return F::uniform;
        else
            return false;
    }
    void coefficients(abi::Derivative derivative, const abi::PairMedia& media, double* __restrict own,
                      double* __restrict other) const override {
        const double *__restrict rho_i = media.rho_i, *__restrict rho_j = media.rho_j;
        const double *__restrict inverse_i = media.inverse_rho_i, *__restrict inverse_j = media.inverse_rho_j;
        const double *__restrict Z_i = media.impedance_i, *__restrict Z_j = media.impedance_j;
        for (int k = 0; k < media.n; ++k) {
            const PairSide i{rho_i[k], inverse_i[k], Z_i[k]}, j{rho_j[k], inverse_j[k], Z_j[k]};
            if constexpr (requires { model.own(i, j, derivative); }) {
                own[k] = model.own(i, j, derivative);
                other[k] = model.other(i, j, derivative);
            } else {
                own[k] = model.own(i, j);
                other[k] = model.other(i, j);
            }
        }
    }
};

}    // namespace detail
}    // namespace sphonic

#define SPHONIC_FORM(name, Struct, doc)                                                                                \
    SPHONIC_ENTRY(sphonic::abi::Form, Struct, sphonic::detail::FormAdapter<Struct>, name, doc)
