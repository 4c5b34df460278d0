#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <sphonic/plugin/abi/arrangement.hpp>
#include <sphonic/plugin/abi/state.hpp>

namespace sphonic {

/// The most energy [J/m^(3-d)] that a set can hold, from what it had and what its sources do to it, if its operators create none.
/// What is added to a rate lengthens the state's vector, in the energy's norm, by no more than its own length. What is
/// imposed can fill the whole set with its own amplitude, and once more with each crossing of the box, as in resonance.
class EnergyBudget {
public:
    EnergyBudget(const abi::Box& box, const abi::Medium& medium) : c0_(medium.c0) {
        for (int a = 0; a < box.dimension; ++a) {
            volume_ *= box.upper[a] - box.lower[a];
            length_ = std::min(length_, box.upper[a] - box.lower[a]);
        }
    }
    void start(double energy) { had_ = std::max(energy, 0.0); }
    /// A rate was added for dt [s]; `energy_of_rate` is the energy that its values would have as a state [J/m^(3-d)/s^2].
    void added(double energy_of_rate, double dt) {
        const double length = std::sqrt(had_) + std::sqrt(energy_of_rate) * dt;
        had_ = length * length;
    }
    /// A value was imposed whose square, times `inertia` (1/K for p, rho0 for u), is an energy density.
    void imposed(double value, double inertia) { density_ = std::max(density_, inertia * value * value); }
    void imposed(const std::vector<double>& values, double inertia) {
        for (const double v : values) imposed(v, inertia);
    }
    /// At time t [s].
    double bound(double t) const {
        const double crossings = 1 + c0_ * t / length_;
        return had_ + volume_ * density_ * crossings * crossings;
    }

private:
    double c0_, volume_ = 1, length_ = std::numeric_limits<double>::infinity();
    double had_ = 0, density_ = 0;
};

}    // namespace sphonic
