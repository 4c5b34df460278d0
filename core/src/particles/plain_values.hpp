#pragma once
#include <array>

#include "plain_pairs.hpp"

namespace sphonic {

/// Per-pair values of a tile that plain rates sum up.
class PlainValues {
public:
    PlainValues(const PairSet& set, const PlainRates& rates, const PairFields& fields) : set_(set), rates_(rates), fields_(fields) {}

    /// Separations and what of the fields is linear in j's values.
    template <int D>
    void take(const PairTile& tile);
    /// The kernel, the viscosity and what forms make of the densities.
    void weigh(int dimension);

    const double* r(int axis) const { return r_[axis].data(); }
    const double* slope() const { return slope_.data(); }
    /// The slope over rho_j where densities vary, else the slope.
    const double* weight() const { return rates_.density >= 0 ? weight_.data() : slope_.data(); }
    const double* pressure() const { return pressure_.data(); }                          ///< own p_i + other p_j
    const double* flow() const { return flow_.data(); }                                  ///< (own u_i + other u_j) . r_ij
    const double* Pi() const { return rates_.viscosity ? Pi_.data() : nullptr; }

private:
    const PairSet& set_;
    const PlainRates& rates_;
    const PairFields& fields_;
    const PairTile* tile_ = nullptr;
    Array r_[3], r2_, distance_, slope_, weight_;
    Array pressure_, flow_, pressure_j_, flow_j_;    ///< those of j apart where a form gives coefficients by pair
    Array u_dot_r_, Pi_;
    Array rho_i_, rho_j_, inverse_rho_i_, inverse_rho_j_, mean_rho_, impedance_i_, impedance_j_, own_, other_;

    void make_room();
    bool by_pair() const { return (rates_.gradient && rates_.gradient->by_pair) || (rates_.divergence && rates_.divergence->by_pair); }
    template <int D, bool velocity, bool pressure, bool density>
    void take_fields();
    void combine(const PlainRates::Derivative& derivative, abi::Derivative kind, double* value_i, const double* value_j);
};

}    // namespace sphonic
