#include <sphonic/plugin/state.hpp>

/// rho = rho0 + drho.
struct TotalDensity final : abi::State {
    void evaluate(const abi::Medium& m, int n, const double* drho, double* rho) const override {
        for (int i = 0; i < n; ++i) rho[i] = m.rho0 + drho[i];
    }
    void invert(const abi::Medium& m, int n, const double* rho, double* drho) const override {
        for (int i = 0; i < n; ++i) drho[i] = rho[i] - m.rho0;
    }
    double derivative(const abi::Medium&, double) const override { return 1; }
};

SPHONIC_STATE("total_density", TotalDensity, "rho = rho0 + drho: density from its change")
