#include <sphonic/plugin/boundary.hpp>

#include <algorithm>

/// First-order absorption (Mur 1981) for p and each component of u, cascaded over the layers of virtual particles (Zhang, Li
/// and Zhang 2017):
///   f_{N+k}(t) = f_{N+k-1}(t - dt) + (c0 dt - dx)/(c0 dt + dx) (f_{N+k-1}(t) - f_{N+k}(t - dt)).
/// Exact for waves that leave at right angles on a fine set. Most of what it leaves there is a sawtooth, the short wave of the same
/// frequency; obliquely a single equation would reflect (1 - cos t)/(1 + cos t), p and u together much less.
struct AbsorbingMur final : abi::Boundary {
    abi::Closure closure() const override { return abi::Closure::layers; }
    bool pressure_suffices() const override { return true; }

    void fill(const abi::GhostLayers& g) const override {
        std::copy_n(g.inner[0], g.n, g.ghost[0]);
        if (g.dt == 0) {
            for (int k = 1; k <= g.layers; ++k) std::copy_n(g.inner[0], g.n, g.ghost[k]);
            return;
        }
        const double advance = g.medium.c0 * g.dt, factor = (advance - g.dx) / (advance + g.dx);
        for (int k = 1; k <= g.layers; ++k)
            for (int i = 0; i < g.n; ++i)
                g.ghost[k][i] = g.before[k - 1][i] + factor * (g.ghost[k - 1][i] - g.before[k][i]);
    }
};

SPHONIC_BOUNDARY("absorbing_mur", AbsorbingMur, "Lets sound out at right angles: Mur's first-order condition, layer by layer")
