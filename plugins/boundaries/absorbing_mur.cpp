#include <sphonic/plugin/boundary.hpp>

/// First-order absorption (Mur 1981) for p and each component of u, cascaded over the layers of virtual particles (Zhang, Li
/// and Zhang 2017). Exact for waves that leave at right angles on a fine set. Most of what it leaves there is a sawtooth, the short
/// wave of the same frequency; obliquely a single equation would reflect (1 - cos t)/(1 + cos t), p and u together much less.
struct AbsorbingMur final : abi::Boundary {
    abi::Closure closure() const override { return abi::Closure::layers; }
    bool pressure_suffices() const override { return true; }
    void fill(const abi::GhostLayers& g) const override { carry_outwards(g); }
};

SPHONIC_BOUNDARY("absorbing_mur", AbsorbingMur, "Lets sound out at right angles: Mur's first-order condition, layer by layer")
