#pragma once
#include <vector>

#include <sphonic/plugin/abi/arrangement.hpp>
#include <sphonic/plugin/abi/media.hpp>

namespace sphonic {

/// A part of the axis x in one medium [m].
struct Stratum {
    double begin = 0, end = 0;
    int medium = 0;
};

/// Of a box of one dimension, from its lower end to its upper, by looks that are no more than `step` [m] apart.
std::vector<Stratum> strata(const abi::Box& box, const abi::Media& media, double step);

/// A coordinate s of the axis in which particles that lie at spacings of their medium's own are evenly spaced: dx/ds = f, the
/// medium's spacing over the first's. In it
///   p_t = -rho0 c0^2 u_x, u_t = -p_x / rho0   become   p_t = -R C^2 u_s, u_t = -p_s / R,   C = c0/f, R = rho0 f,
/// of the same impedance: sets of even spacing and grids run in it as they are. Beyond the box the outermost media go on.
/// Of one dimension, as the medium of each direction would be another in more.
class Stretch {
public:
    /// Of media with spacings of their own; the first's is the box's. Both coordinates begin at the box's lower end.
    Stretch(const abi::Box& box, const abi::Media& media);

    /// x of s [m].
    double place(double s) const;
    /// s of x [m].
    double site(double x) const;
    /// f at s.
    double factor(double s) const;
    /// f by number of the medium.
    const std::vector<double>& factors() const { return factors_; }

    /// A medium of x in s, where dx/ds = `factor`.
    static abi::Medium seen(const abi::Medium& medium, double factor) { return {.c0 = medium.c0 / factor, .rho0 = medium.rho0 * factor}; }

private:
    /// A stratum's beginning.
    struct Piece {
        double x, s, factor;
    };
    std::vector<double> factors_;
    std::vector<Piece> pieces_;
};

}    // namespace sphonic
