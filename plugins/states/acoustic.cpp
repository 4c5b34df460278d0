#include <sphonic/plugin/state.hpp>

/// p = c0^2 drho: the linear equation of state of small sounds.
struct Acoustic final : abi::State {
    void evaluate(const abi::Medium& m, int n, const double* drho, double* p) const override {
        for (int i = 0; i < n; ++i) p[i] = m.c0 * m.c0 * drho[i];
    }
    void invert(const abi::Medium& m, int n, const double* p, double* drho) const override {
        for (int i = 0; i < n; ++i) drho[i] = p[i] / (m.c0 * m.c0);
    }
    double derivative(const abi::Medium& m, double) const override { return m.c0 * m.c0; }
};

SPHONIC_STATE("acoustic", Acoustic, "p = c0^2 drho: pressure from the density change of a small sound")
