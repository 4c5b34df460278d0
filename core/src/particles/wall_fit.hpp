#pragma once
#include <array>
#include <vector>

#include <sphonic/case.hpp>

#include "local_fit.hpp"

namespace sphonic {

/// Fields next to a wall, from the values of particles about a point over it at height D, to the point behind it at depth D. By
/// weighted least squares within 2 dx, the wall's condition being part of the fit; z is the distance from the wall, t the
/// position along it:
///   even  a + b.t            p and the tangential u at a rigid wall
///   odd   a z                p and the tangential u at a soft wall; with z/(1 + kz/2), the normal u at a rigid one
///   even  (a + b.t)/(1 + kz) the normal u at a soft wall; in space (1 + kz/2)^2, as on a sphere
/// where k = div n is the wall's curvature: p = 0 all along a wall means div u = 0 there, so that u_n thins out as the normals
/// spread. Where particles are too few for b, a alone is fitted.
class WallFit {
public:
    static constexpr double radius = 2;    ///< [dx]

    /// `normal` into the fluid, `depth` D [m] and `curvature` k [1/m].
    WallFit(const Case& scene, Obstacle::Wall wall, const double* normal, double depth, double curvature);

    /// A particle at `r` from the point over the wall, at distance z from the wall [m].
    void add(const double* r, double z);

    /// What each particle's value counts for behind the wall: of scalars and tangential components, and of normal ones.
    std::vector<double> along() const { return along_.weights(along_at(origin, -depth_)); }
    std::vector<double> across() const { return across_.weights(across_at(origin, -depth_)); }

private:
    using Basis = LocalFit::Basis;
    static constexpr Basis origin{1};    ///< 1 and the position along the wall [dx]
    Obstacle::Wall wall_;
    int d_;
    double dx_, depth_, curvature_;    ///< the latter two in units of dx; of a line in the wall
    std::array<double, 3> tangent_[2]{};
    LocalFit along_, across_;

    Basis along_at(const Basis& t, double z) const { return wall_ == Obstacle::Wall::rigid ? t : Basis{z}; }
    Basis across_at(const Basis& t, double z) const;
};

}    // namespace sphonic
