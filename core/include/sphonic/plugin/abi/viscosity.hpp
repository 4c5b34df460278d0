#pragma once

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

/// A pairwise artificial viscosity Pi_ij [m^5 kg^-1 s^-2], added to p_i/rho_i^2 + p_j/rho_j^2.
/// Symmetric in i and j. Where the geometry of pairs is constant, `prepare` is called once and `apply` at every step.
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
    /// Pi for n pairs that share one set of prepared data (one lattice offset).
    virtual void apply(int n, const double* prepared, const double* u_dot_r, double* Pi) const = 0;

    /// Slope dPi/d(u.r) at u.r -> 0- of an approaching pair [m^3 kg^-1 s^-1]: the linear part that bounds the stable step.
    virtual double slope(const PairBlock& block) const = 0;
};

}    // namespace sphonic::abi
