#include <sphonic/plugin/integrator.hpp>

/// y_{n+1} = y_n + dt f(y_n) (Euler 1768): first order, |1 + i omega dt| > 1 at any step.
struct ForwardEuler final : abi::Integrator {
    void step(abi::System& s, const abi::Step& now) const override {
        s.advance(abi::everything, now.t, now.dt);
        s.settle(abi::everything, now.t + now.dt);
    }
};

SPHONIC_INTEGRATOR(
    "forward_euler", ForwardEuler,
    "First order; stable limit 0 without damping: grows by (omega dt)^2 / 2 per step; for studying the failure")
