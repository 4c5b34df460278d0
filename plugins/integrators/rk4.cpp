#include <sphonic/plugin/integrator.hpp>

/// The classical Runge-Kutta method:
///    0  |
///   1/2 | 1/2
///   1/2 |  0   1/2
///    1  |  0    0    1
///       | 1/6  1/3  1/3  1/6
/// Fourth order, stable to omega dt = 2 sqrt 2, slightly damped.
struct Rk4 final : abi::Integrator {
    void step(abi::System& s, const abi::Step& now) const override {
        constexpr double node[4] = {0, 0.5, 0.5, 1}, weight[4] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};
        constexpr abi::Group all = abi::everything;
        const abi::Slot begin = s.history("begin"), sum = s.history("sum"), k = s.history("k");
        s.copy(all, abi::state, begin);
        s.copy(all, abi::state, sum);
        for (int stage = 0; stage < 4; ++stage) {
            s.rate(all, now.t + node[stage] * now.dt, k);
            s.axpy(all, weight[stage] * now.dt, k, sum);
            const bool last = stage == 3;
            s.copy(all, last ? sum : begin, abi::state);
            if (!last) s.axpy(all, node[stage + 1] * now.dt, k, abi::state);
            s.settle(all, now.t + (last ? 1 : node[stage + 1]) * now.dt);
        }
    }
};

SPHONIC_INTEGRATOR("rk4", Rk4, "Classical fourth-order Runge-Kutta; stable to omega dt = 2.83; four evaluations a step")
