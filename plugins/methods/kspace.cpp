#include <sphonic/plugin/method.hpp>

#include "kspace/pseudospectral.hpp"

/// Fourier's derivatives, staggered by half a spacing, with the k-space correction in time (Tabei, Mast and Waag 2002; Cox et al. 2007):
///   u_a -= dt/rho0 F^-1 { i k_a kappa exp(+i k_a dx/2) F p },   p -= dt K F^-1 { sum_a i k_a kappa exp(-i k_a dx/2) F u_a },
///   kappa = sin(b)/b,  b = c |k| dt/2,  c the fastest medium's sound speed,  K = rho0 c0^2,
/// p on the case's lattice at whole steps, u_a half a spacing and half a step from it. In one medium exact for every wave of the lattice
/// at any step; what a source adds is multiplied by cos(b), and then radiates exactly too. In slower media the order in time is 2.
///
/// The box must repeat along each axis, or have absorbing layers at both ends of it: it then repeats within them, and what crosses one
/// crosses the other too. Interfaces between media are sharp, taken as by fdtd; they leave a ripple of the lattice's shortest waves.
struct KSpace final : abi::Method {
    int threads = 1;

    static constexpr auto parameters() {
        return std::array{integer("threads", &KSpace::threads, 1, 256, "that the transforms use; results may differ in the last digits")};
    }

    bool meshfree() const override { return false; }
    bool several_media() const override { return true; }
    bool carry(const abi::Medium& medium, const abi::Box& box, double, const double* k, abi::CarriedWave& wave) const override {
        wave = kspace::carried(medium, box.dimension, k);
        return true;
    }
    std::unique_ptr<abi::Solver> discretise(const abi::Scene& scene) const override { return std::make_unique<kspace::Pseudospectral>(scene, threads); }
};

SPHONIC_METHOD("kspace", KSpace, "Fourier's derivatives with the k-space correction in time: exact in one medium without walls")
