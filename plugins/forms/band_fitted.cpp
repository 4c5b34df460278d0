#include <sphonic/plugin/form.hpp>

#include <array>
#include <memory>

#include "band_fitted/cloud_band.hpp"
#include "band_fitted/lattice_band.hpp"

/// Weights made for sound, for waves of |k| dx <= 2 pi / points_per_wavelength. The symbol F(k) is to follow
/// 2 sin(c0 |k| dt/2)/(c0 dt), which cancels the leapfrog's error in time too (|k| for other integrators), in all directions. After n
/// wavelengths a wave is out by some 2 pi n times the relative error of F.
///
/// On a lattice: antisymmetric, one for each class of neighbours within `support` spacings, with the least largest error while
/// |F| stays within what the integrator bears over the whole zone. Energy is kept.
///
/// On a cloud: by least squares over all such waves, for each particle of its own (band_fitted/cloud_band.hpp). The weights of a
/// pair are not opposite then, and what the band does not contain would grow by .1 to .2 c0/dx; damping prevents that. In the plane
/// no mode of 24 x 24 particles grows up to a jitter of .3 dx, and a wave of 8 points per wavelength loses .5 % in ten periods.
struct BandFitted {
    double points_per_wavelength = 8, support = 3, cloud_support = 0, damping = 1;

    static constexpr auto parameters() {
        using B = BandFitted;
        return std::array{real("points_per_wavelength", &B::points_per_wavelength, "1", 3, 100, "of the shortest wave to carry well"),
                          real("support", &B::support, "dx", 1, 6, "radius of the neighbourhood on a lattice"),
                          real("cloud_support", &B::cloud_support, "dx", 0, 6, "radius of the neighbourhood on a cloud; 0: 6 in 1-D, 4 in 2-D, 3.3 in 3-D"),
                          real("damping", &B::damping, "1", 0, 4, "on a cloud, of what the weights do not carry; 1 is for jitters up to 0.3 dx")};
    }
    /// Between two media as in the impedance form.
    static constexpr double other(PairSide i, PairSide j, abi::Derivative derivative) {
        return 2 * (derivative == abi::Derivative::gradient ? i.impedance : j.impedance) / (i.impedance + j.impedance);
    }
    static constexpr double own(PairSide i, PairSide j, abi::Derivative derivative) { return -other(i, j, derivative); }

    double reach() const { return support; }
    void fit(const abi::LatticeFit& lattice, double* weight) const { band::LatticeBand{points_per_wavelength}.fit(lattice, weight); }

    double cloud_reach(int dimension) const {
        constexpr double usual[4] = {0, 6, 4, 3.3};
        return cloud_support > 0 ? cloud_support : usual[dimension];
    }
    std::unique_ptr<abi::CloudFit> cloud_fit(int dimension, double courant) const {
        return std::make_unique<band::CloudBand>(dimension, courant, points_per_wavelength, cloud_reach(dimension), damping);
    }
};

SPHONIC_FORM("band_fitted", BandFitted, "Weights fitted to a band of waves and to the step, on frozen lattices and clouds")
