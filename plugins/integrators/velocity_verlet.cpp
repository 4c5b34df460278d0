#include <sphonic/plugin/integrator.hpp>

/// Half a step of the first group (u), a whole one of the others, half a step of the first again.
/// The second half's rate opens the next step, so a step costs one evaluation. What stands for u is the mean of its values half a
/// step before and after, cos(omega dt/2) times the wave's; what is given at t = 0 becomes such a mean.
struct VelocityVerlet final : abi::Integrator {
    void begin(abi::System& s, double dt) const override { centre(s, dt); }
    void step(abi::System& s, const abi::Step& now) const override {
        const abi::Slot kick = s.history("kick");
        if (now.index == 0) s.rate(0, now.t, kick);
        s.axpy(0, now.dt / 2, kick, abi::state);
        s.settle(0, now.t + now.dt / 2);
        for (abi::Group g = 1; g < s.groups(); ++g) {
            s.advance(g, now.t + now.dt / 2, now.dt);
            s.settle(g, now.t + now.dt);
        }
        s.rate(0, now.t + now.dt, kick);
        s.axpy(0, now.dt / 2, kick, abi::state);
        s.settle(0, now.t + now.dt);
    }
    abi::Stagger stagger() const override { return abi::Stagger::centred; }
};

SPHONIC_INTEGRATOR("velocity_verlet", VelocityVerlet,
                   "Kick-drift-kick: second order with u and p at the same time; stable to omega dt = 2")
