#pragma once
#include <sphonic/plugin/abi/state.hpp>

namespace sphonic::abi {

/// What lies beyond a face of the box.
enum class Closure : int {
    free,        ///< nothing
    periodic,    ///< the opposite side
    mirror,      ///< virtual particles with the values of their mirror images, even or odd
    layers       ///< virtual particles in layers of a lattice, whose values `fill` works out
};

/// What a field's component is to a face.
enum class Part : int { scalar, normal, tangential };

/// The virtual particles beyond one face of a lattice, for one component of a field: column i of layer k lies k spacings beyond
/// the face's own particle i (k = 0), `inner` as far inside. Values are differences from rest.
struct GhostLayers {
    Part part = Part::scalar;
    int n = 0;                              ///< columns
    int layers = 0;                         ///< 1 ... layers are to be filled
    double t = 0;                           ///< of the values [s]
    double dt = 0;                          ///< since the last call for this component [s]; 0 in the first
    double dx = 0;                          ///< [m]
    Medium medium;
    const double* const* inner = nullptr;       ///< [0 ... layers + 1][n]; 0: the face's particles
    const double* const* pressure = nullptr;    ///< the same of p, as it stands
    double* const* memory = nullptr;            ///< [0 ... layers][n], the wall's own, as it left them in the last call
    double* const* ghost = nullptr;             ///< [0 ... layers][n] to write; [0] replaces the face's own values
};

/// A condition on a face of the box. Walls with memory act once per step: integrators with stages are refused for them.
class Boundary {
public:
    static constexpr const char* kind = "boundary";
    virtual ~Boundary() = default;

    virtual Closure closure() const = 0;
    /// True if the wall lies half a spacing beyond the last particles, not on them.
    virtual bool half_way() const { return false; }
    /// +1 or -1: how the mirror images take a component. Where a wall lies on particles, an odd component vanishes there.
    virtual int parity(Part) const { return 1; }
    /// Rate [1/s] at which all fields go to rest at a distance [m] inside the face; applied once per step.
    virtual double damping(double, const Medium&) const { return 0; }
    /// What a mirror's wall gives way: velocity into it over the pressure on it [m/(Pa s)], acting once per step. On regular sets.
    virtual double admittance() const { return 0; }
    /// For Closure::layers. Once per step and component, p before u.
    virtual void fill(const GhostLayers&) const {}
    /// For Closure::layers: true if one layer of p is the whole wall where u lies half a spacing beyond p.
    virtual bool pressure_suffices() const { return false; }
};

}    // namespace sphonic::abi
