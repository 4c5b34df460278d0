#include <sphonic/plugin/integrator.hpp>

/// Second-order Adams-Bashforth, f_n the rates at t_n:
///   y_{n+1} = y_n + dt (3/2 f_n - 1/2 f_{n-1}),
/// begun by a step of Heun's: y_1 = y_0 + dt/2 (f_0 + f(y_0 + dt f_0)).
/// Its amplification is a root of xi^2 - (1 + 3z/2) xi + z/2 = 0, z = i omega dt: without damping it grows by
/// (omega dt)^4 / 4 per step at any step.
struct Ab2 final : abi::Integrator {
    void step(abi::System& s, const abi::Step& now) const override {
        constexpr abi::Group all = abi::everything;
        const abi::Slot rates = s.history("rates"), before = s.history("before");
        if (now.index == 0) {
            s.rate(all, now.t, before);
            s.axpy(all, now.dt, before, abi::state);
            s.settle(all, now.t + now.dt);
            s.rate(all, now.t + now.dt, rates);
            s.axpy(all, now.dt / 2, rates, abi::state);
            s.axpy(all, -now.dt / 2, before, abi::state);
        } else {
            s.rate(all, now.t, rates);
            s.axpy(all, 1.5 * now.dt, rates, abi::state);
            s.axpy(all, -0.5 * now.dt, before, abi::state);
            s.copy(all, rates, before);
        }
        s.settle(all, now.t + now.dt);
    }
};

SPHONIC_INTEGRATOR("ab2", Ab2,
                   "Adams-Bashforth, second order, one evaluation a step; stable limit 0 without damping: grows by "
                   "(omega dt)^4 / 4 per step")
