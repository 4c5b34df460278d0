#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <sphonic/case.hpp>

#include "particle_media.hpp"
#include "store.hpp"

namespace sphonic {

/// What flows into walls that give way (abi::Boundary::admittance), once per step, line by line along the normal. With the wall's
/// pressure P = b.p by wall_footprint, driven by its mean over the step,
///   p_i -= b_i/h_i rho0 c0^2 dt/(Z dx) (P_n + P_{n+1})/2,   h_i = 1/2 on the wall and 1 before it,
/// which is solved for P_{n+1}. Where u is kicked by p_n and p_{n+1} alone, it takes dt (P_n + P_{n+1})^2/(4 Z) from the staggered
/// energy per area of the wall.
class WallFlow {
public:
    WallFlow() = default;
    /// For steps of dt [s].
    WallFlow(const Case& scene, const ParticleMedia& media, const Layout& layout, int threads, double dt);

    bool any() const { return !faces_.empty(); }
    /// Particles along the normal that a wall reads and changes.
    long depth() const {
        long most = 0;
        for (const Face& f : faces_) most = std::max(most, long(f.put.size()));
        return most;
    }
    /// Takes the walls' pressure as it is now.
    void begin(const double* field, double rest);
    /// The walls' pressure at the end of the last step.
    std::vector<std::span<double>> remembered();
    /// Over a step, on p or the variable that p is computed from, which is `rest` at rest.
    void apply(double* field, double rest);

private:
    struct Face {
        std::ptrdiff_t inward;             ///< from one particle of a line to the next in a field
        std::vector<double> read, put;     ///< b_i, b_i/h_i
        double beta = 0;                   ///< sum of read_i put_i
        std::vector<std::ptrdiff_t> at;    ///< the wall's particles
        std::vector<double> rate;          ///< rho0 c0^2 dt/(Z dx) at each
        std::vector<double> pressure;      ///< P at each, at the end of the last step

        double value(const double* line, double rest) const;
    };
    int threads_ = 1;
    std::vector<Face> faces_;

    void add_face(const Case& scene, const ParticleMedia& media, const Layout& layout, int axis, bool upper, double dt);
};

}    // namespace sphonic
