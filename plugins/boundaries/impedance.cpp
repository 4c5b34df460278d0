#include <sphonic/plugin/boundary.hpp>

/// A locally reacting wall on the face's particles: u.n = p/Z with a given real Z, at every angle of incidence,
///   R(theta) = (Z cos(theta) - rho0 c0)/(Z cos(theta) + rho0 c0).
/// Mirror images as of a rigid wall, and what flows into it taken out of p by a footprint before it. On regular sets, for integrators
/// that keep the states they pass through.
struct Impedance final : abi::Boundary {
    double impedance = 0;

    static constexpr auto parameters() {
        return std::array{real("impedance", &Impedance::impedance, "Pa s/m", positive, 1e30, "Z; rho0 c0 absorbs sound at right angles")};
    }
    abi::Closure closure() const override { return abi::Closure::mirror; }
    int parity(abi::Part part) const override { return part == abi::Part::normal ? -1 : 1; }
    double admittance() const override { return 1 / impedance; }
};

SPHONIC_BOUNDARY("impedance", Impedance, "A wall that gives way: the pressure on it over the velocity into it is Z")
