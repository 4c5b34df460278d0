#pragma once
#include <cstddef>

namespace sphonic::abi {

/// Up to some thousands of packed pairs ij. Each of h, c and rho is uniform when its array is null.
struct PairBlock {
    int n = 0;
    const double* u_dot_r = nullptr;     ///< u_ij . r_ij [m^2/s], negative for approaching pairs
    const double* r2 = nullptr;          ///< |r_ij|^2 [m^2], > 0
    double h = 0, c = 0, rho = 0;        ///< pair means where uniform
    const double* h_each = nullptr;      ///< [m]
    const double* c_each = nullptr;      ///< [m/s]
    const double* rho_each = nullptr;    ///< [kg/m^3]
};

/// The pairs (i, i + at) of n consecutive lattice particles and one neighbour offset: u_ij . r_ij is formed from the
/// fields inside the plugin's own loop, which saves it a pass through memory.
struct RowPairs {
    int dimension = 1;
    int n = 0;
    std::ptrdiff_t at = 0;                                ///< from i to j in the fields
    const double* u[3] = {nullptr, nullptr, nullptr};     ///< velocity components at the first i [m/s]
    double r[3] = {0, 0, 0};                              ///< r_ij = x_i - x_j [m]
};

/// A pairwise artificial viscosity Pi_ij [m^5 kg^-1 s^-2], added to p_i/rho_i^2 + p_j/rho_j^2.
/// Symmetric in i and j. Where the geometry of pairs is constant, `prepare` is called once and `row` at every step.
class Viscosity {
public:
    static constexpr const char* kind = "viscosity";
    virtual ~Viscosity() = default;

    /// Pi for each pair of a block.
    virtual void pairs(const PairBlock& block, double* Pi) const = 0;

    /// Doubles of prepared data per pair.
    virtual int prepared_size() const = 0;
    /// Prepared data of each pair, [pair][prepared_size()]; `block.u_dot_r` is not read.
    virtual void prepare(const PairBlock& block, double* prepared) const = 0;
    /// Pi for the pairs of a row, which share one set of prepared data.
    virtual void row(const RowPairs& pairs, const double* prepared, double* Pi) const = 0;

    /// Slope dPi/d(u.r) at u.r -> 0- of an approaching pair [m^3 kg^-1 s^-1]: the linear part that bounds the stable step.
    virtual double slope(const PairBlock& block) const = 0;
};

}    // namespace sphonic::abi
