#include <sphonic/plugin/boundary.hpp>

/// Damps p and u alike over `thickness` before the face, at the rate
///   sigma(s) = sigma_m (1 - s/D)^3,   s the distance from the face,
/// so that the layer has the medium's impedance and a wave at right angles enters it without reflection. The wall behind it is
/// rigid: what comes back has crossed the layer twice, exp(-2/c0 integral sigma ds), which is 1 dB below `attenuation` to leave
/// room for what the entrance returns. Obliquely the entrance returns more: `check` says how much at 60 degrees. On any set,
/// for any integrator.
struct AbsorbingLayer final : abi::Boundary {
    double thickness = 0, attenuation = 40;

    static constexpr auto parameters() {
        using A = AbsorbingLayer;
        return std::array{real("thickness", &A::thickness, "m", positive, infinite, "D, inside the box; a wavelength or more of the lowest sound"),
                          real("attenuation", &A::attenuation, "dB", 1, 300, "of what comes back at right angles")};
    }

    abi::Closure closure() const override { return abi::Closure::mirror; }
    int parity(abi::Part part) const override { return part == abi::Part::normal ? -1 : 1; }
    double damping(double distance, const abi::Medium& medium) const override {
        if (distance >= thickness) return 0;
        const double depth = 1 - distance / thickness, nepers = (attenuation + margin) * std::log(10.0) / 20;
        return (order + 1) * medium.c0 * nepers / (2 * thickness) * std::pow(depth, order);
    }

private:
    static constexpr int order = 3;
    static constexpr double margin = 1;    ///< for what the entrance returns [dB]
};

SPHONIC_BOUNDARY("absorbing_layer", AbsorbingLayer, "A layer that damps sound before it reaches the face; on any set, at any angle")
