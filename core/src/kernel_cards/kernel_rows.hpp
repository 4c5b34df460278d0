#pragma once
#include <limits>

#include <sphonic/kernel_card.hpp>

namespace sphonic {

/// Works out rows; what depends on the integrator alone is found once.
class KernelRows {
public:
    explicit KernelRows(Registry& registry);

    /// Nothing where particles would have more than `most_neighbours`, or too few to span the space, or where the work would surely
    /// be more than `least_work`.
    std::optional<KernelRow> row(const std::string& kernel, int dimension, double h_over_dx, double least_work = std::numeric_limits<double>::infinity()) const;
    /// The row of least work over h/dx, in steps of 0.1.
    std::optional<KernelRow> best(const std::string& kernel, int dimension) const;
    KernelDispersion dispersion(const std::string& kernel, int dimension, double h_over_dx) const;

private:
    Registry& registry_;
    std::map<std::string, double> oscillation_;    ///< largest stable omega dt, by integrator
};

}    // namespace sphonic
