#include <sphonic/plugin/integrator.hpp>

/// The explicit midpoint method (Runge 1895):
///    0  |
///   1/2 | 1/2
///       |  0    1
/// Second order, |1 + z + z^2/2| with z = i omega dt: without damping it grows by (omega dt)^4 / 8 per step at any step.
struct Rk2 final : abi::Integrator {
    void step(abi::System& s, const abi::Step& now) const override {
        constexpr abi::Group all = abi::everything;
        const abi::Slot begin = s.history("begin"), k = s.history("k");
        s.copy(all, abi::state, begin);
        s.rate(all, now.t, k);
        s.axpy(all, now.dt / 2, k, abi::state);
        s.settle(all, now.t + now.dt / 2);
        s.rate(all, now.t + now.dt / 2, k);
        s.copy(all, begin, abi::state);
        s.axpy(all, now.dt, k, abi::state);
        s.settle(all, now.t + now.dt);
    }
};

SPHONIC_INTEGRATOR(
    "rk2", Rk2,
    "Midpoint Runge-Kutta, second order; stable limit 0 without damping: grows by (omega dt)^4 / 8 per step")
