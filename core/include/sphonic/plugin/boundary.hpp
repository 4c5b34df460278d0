#pragma once
/// What a boundary plugin includes: derive from sphonic::abi::Boundary and close the file with SPHONIC_BOUNDARY("name", Struct, "what it is").

#include <algorithm>

#include <sphonic/plugin/abi/boundary.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

#define SPHONIC_BOUNDARY(name, Struct, doc) SPHONIC_PLUGIN(sphonic::abi::Boundary, name, Struct, doc)

namespace sphonic {

/// Fills the layers with what leaves through the face at the speed c0, by Mur's first-order condition (1981) from layer to layer,
///   f_k(t) = f_{k-1}(t - dt) + (c0 dt - dx)/(c0 dt + dx) (f_{k-1}(t) - f_k(t - dt)),
/// and remembers it. The first call takes the face's values.
inline void carry_outwards(const abi::GhostLayers& g) {
    const double advance = g.medium.c0 * g.dt, factor = (advance - g.dx) / (advance + g.dx);
    std::copy_n(g.inner[0], g.n, g.ghost[0]);
    for (int k = 1; k <= g.layers; ++k)
        for (int i = 0; i < g.n; ++i)
            g.ghost[k][i] = g.dt > 0 ? g.memory[k - 1][i] + factor * (g.ghost[k - 1][i] - g.memory[k][i]) : g.inner[0][i];
    for (int k = 0; k <= g.layers; ++k) std::copy_n(g.ghost[k], g.n, g.memory[k]);
}

}    // namespace sphonic
