#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <sphonic/chart.hpp>
#include <sphonic/registry.hpp>

namespace sphonic {

/// A property that every kernel should have, in one dimension, and how far this one has it.
struct KernelLaw {
    std::string what;
    int dimension;
    double value;    ///< 0 if it holds exactly
    bool holds;
};

/// The Fourier transform of a kernel over its value at 0, by k h [rad].
struct KernelTransform {
    int dimension;
    std::vector<double> kh, value;
    double least = 0;    ///< below zero, many neighbours clump: the pairing instability (Dehnen and Aly 2012)
};

/// What a kernel does to sound on a lattice of one spacing.
struct KernelRow {
    int dimension;
    double h_over_dx;
    int neighbours;
    double speed_error;     ///< c/c0 - 1 of long waves by the plain pair of forms, along an axis or a diagonal: the larger
    double cutoff_ppw;      ///< points per wavelength of the wave of highest frequency along an axis: no shorter one carries a signal
    std::map<std::string, double> courant_dx;    ///< largest stable c0 dt/dx of the plain pair, by integrator that has a limit
    /// With corrected weights, in the worse of these directions: from how many points per wavelength on the relative L2 error after ten
    /// wavelengths is below 1 % and 0.1 %, time being exact. None up to 1000.
    std::optional<double> ppw_1_percent, ppw_01_percent;
    /// Pairs for 1 %: of a volume of one wavelength's edges over a period, by leapfrog at its limit.
    std::optional<double> work() const;
};

/// c/c0 of the waves of a row by points per wavelength, along an axis, with corrected weights.
struct KernelDispersion {
    double h_over_dx;
    std::vector<double> per_wavelength, speed;
};

struct KernelCard {
    std::string name, doc, file;
    double support;
    std::vector<int> dimensions;
    std::vector<KernelLaw> laws;
    std::vector<KernelTransform> transforms;    ///< by dimension
    std::vector<KernelRow> rows;
    std::vector<KernelRow> recommended;         ///< by dimension: the h/dx of least work
    std::vector<KernelDispersion> dispersion;   ///< in the lowest dimension
};

/// Rows are made where particles have at most this many neighbours.
inline constexpr int most_neighbours = 500;

/// The report card of a kernel plugin, with its parameters' defaults.
KernelCard kernel_card(Registry& registry, const std::string& kernel);

/// The rows of least work of several kernels in one dimension, best first, as (kernel, row); those that never reach 1 % are left out.
std::vector<std::pair<std::string, KernelRow>> rank_kernels(Registry& registry, const std::vector<std::string>& kernels, int dimension);

/// Profile, transform and dispersion.
Chart kernel_chart(const KernelCard& card);
/// Transforms and dispersion of several.
Chart kernel_comparison(const std::vector<KernelCard>& cards);

}    // namespace sphonic
