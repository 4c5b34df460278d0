#pragma once
/// A kernel plugin is a struct with w(q), dw(q), support() and sigma(d), and one macro line.
/// Each may be static or a const member (then parameters can enter), and may take the dimension as a last argument.

#include <sphonic/plugin/abi/kernel.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

namespace sphonic {

/// The dimensions that a kernel claims.
template <class... D>
constexpr unsigned dimensions(D... d) {
    return ((1u << unsigned(d)) | ... | 0u);
}

/// Non-negative part: splines written with it have no branches and vectorise.
constexpr double plus(double x) { return x > 0 ? x : 0; }

namespace detail {

template <class K, unsigned Claimed>
class KernelAdapter final : public abi::Kernel {
public:
    K model;

    void evaluate(int d, int n, const double* r, double h, double* W, double* dW_over_r) const override {
        const double edge = support() * h, inverse_h = 1 / h;
        double scale = sigma(d);
        for (int a = 0; a < d; ++a) scale *= inverse_h;
        if (W) values(d, n, r, inverse_h, edge, scale, W);
        if (dW_over_r) slopes(d, n, r, inverse_h, edge, scale * inverse_h * inverse_h, dW_over_r);
    }
    double support() const override { return model.support(); }
    bool defined(int d) const override { return Claimed >> unsigned(d) & 1u; }
    abi::KernelProperties properties() const override {
        if constexpr (requires { model.properties(); })
            return model.properties();
        else
            return {};
    }

private:
    double sigma(int d) const { return model.sigma(d); }
    double w(double q, int d) const {
        if constexpr (requires { model.w(q, d); })
            return model.w(q, d);
        else
            return model.w(q);
    }
    double dw(double q, int d) const {
        if constexpr (requires { model.dw(q, d); })
            return model.dw(q, d);
        else
            return model.dw(q);
    }
    void values(int d, int n, const double* __restrict r, double inverse_h, double edge, double scale,
                double* __restrict W) const {
#pragma omp simd
        for (int k = 0; k < n; ++k) {
            const double q = r[k] * inverse_h, value = scale * w(q, d);
            W[k] = r[k] < edge ? value : 0;
        }
    }
    void slopes(int d, int n, const double* __restrict r, double inverse_h, double edge, double scale,
                double* __restrict dW_over_r) const {
#pragma omp simd
        for (int k = 0; k < n; ++k) {
            const double q = r[k] * inverse_h, value = scale * dw(q, d) / (q > 0 ? q : 1);
            dW_over_r[k] = (q > 0) & (r[k] < edge) ? value : 0;
        }
    }
};

}    // namespace detail
}    // namespace sphonic

#define SPHONIC_KERNEL(name, Struct, claimed, doc)                                                                     \
    using sphonic_adapter = sphonic::detail::KernelAdapter<Struct, claimed>;                                           \
    SPHONIC_ENTRY(sphonic::abi::Kernel, Struct, sphonic_adapter, name, doc)
