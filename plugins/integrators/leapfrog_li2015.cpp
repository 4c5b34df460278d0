#include <sphonic/plugin/integrator.hpp>

/// Li, Zhang, Zhang (2015), eqs 14-15, taken literally: the fields are predicted by half a step with the last rates,
/// the rates taken there, and the saved fields advanced by a whole step (half a step at first).
/// For frozen linear sets this is AB2: weakly unstable, growing by about (omega dt)^4 / 4 per step.
struct LeapfrogLi2015 final : abi::Integrator {
    void step(abi::System& s, const abi::Step& now) const override {
        const abi::Slot rates = s.history("rates"), saved = s.history("saved");
        const bool first = now.index == 0;
        s.copy(abi::fields, abi::state, saved);
        if (!first) {
            s.axpy(abi::fields, now.dt / 2, rates, abi::state);
            s.settle(abi::fields, now.t);
        }
        s.rate(abi::fields, now.t, rates);
        s.copy(abi::fields, saved, abi::state);
        s.axpy(abi::fields, first ? now.dt / 2 : now.dt, rates, abi::state);
        s.advance(abi::positions, now.t, now.dt);
        s.settle(abi::everything, now.t + now.dt);
    }
};

SPHONIC_INTEGRATOR("leapfrog_li2015", LeapfrogLi2015,
                   "The leapfrog printed by Li et al. (2015), which is AB2: for reproducing the paper; weakly unstable")
