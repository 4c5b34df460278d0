#include <sphonic/plugin/integrator.hpp>

/// One group after the other, each with the newest values of the others: u, then p and x.
/// Second order for u at half steps; stable to omega dt = 2; conserves the staggered energy.
struct SymplecticEuler final : abi::Integrator {
    void step(abi::System& s, const abi::Step& now) const override {
        for (abi::Group g = 0; g < s.groups(); ++g) {
            s.advance(g, now.t, now.dt);
            s.settle(g, now.t + now.dt);
        }
    }
    abi::Stagger stagger() const override { return abi::Stagger::behind; }
};

SPHONIC_INTEGRATOR("symplectic_euler", SymplecticEuler,
                   "Groups in turn; stable to omega dt = 2; one evaluation a step, no extra storage")
