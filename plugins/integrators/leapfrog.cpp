#include <sphonic/plugin/integrator.hpp>

/// Staggered leapfrog (Yee 1966), for the first group u and the others p:
///   u_{n+1/2} = u_{n-1/2} + dt a(p_n),   p_{n+1} = p_n + dt b(u_{n+1/2}),
/// begun by u_{1/2} = u_0 + dt^2/8 d2u/dt2 + dt/2 a(p_0), so that u given at t = 0 counts there: second order for p and for u at
/// half steps, without an error from the start (the kick alone leaves (omega dt)^2/8). After the first step it is symplectic
/// Euler: stable to omega dt = 2, conserves the staggered energy.
struct Leapfrog final : abi::Integrator {
    void begin(abi::System& s, double dt) const override { centre(s, dt); }
    void step(abi::System& s, const abi::Step& now) const override {
        s.advance(0, now.t, now.index == 0 ? now.dt / 2 : now.dt);
        s.settle(0, now.t + now.dt / 2);
        for (abi::Group g = 1; g < s.groups(); ++g) {
            s.advance(g, now.t + now.dt / 2, now.dt);
            s.settle(g, now.t + now.dt);
        }
    }
    abi::Stagger stagger() const override { return abi::Stagger::behind_after_start; }
};

SPHONIC_INTEGRATOR(
    "leapfrog", Leapfrog,
    "Staggered leapfrog: second order from u and p at t = 0; stable to omega dt = 2; one evaluation a step")
