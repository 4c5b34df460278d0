#pragma once
/// What an integrator plugin includes: derive from sphonic::abi::Integrator and close the file with SPHONIC_INTEGRATOR("name", Struct, "what it is").

#include <sphonic/plugin/abi/integrator.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

namespace sphonic {

/// For schemes in which the first group u stands at half steps: u_0 becomes the mean of u(-dt/2) and u(dt/2), about
/// u_0 + dt^2/8 d2u/dt2, so that a kick of dt/2 takes it to u(dt/2) up to dt^4, not to dt^2. The second derivative comes of
/// the other groups' change over dt/4.
inline void centre(abi::System& s, double dt) {
    const abi::Slot kept = s.history("start");
    for (abi::Group g = 1; g < s.groups(); ++g) {
        s.copy(g, abi::state, kept);
        s.advance(g, 0, dt / 4);
        s.settle(g, dt / 4);
    }
    s.advance(0, dt / 4, dt / 2);
    s.settle(0, dt / 2);
    for (abi::Group g = 1; g < s.groups(); ++g) {
        s.copy(g, kept, abi::state);
        s.settle(g, 0);
    }
    s.advance(0, 0, -dt / 2);
    s.settle(0, 0);
}

}    // namespace sphonic

#define SPHONIC_INTEGRATOR(name, Struct, doc) SPHONIC_PLUGIN(sphonic::abi::Integrator, name, Struct, doc)
