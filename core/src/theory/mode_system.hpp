#pragma once
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include <sphonic/stability.hpp>

namespace sphonic {

/// One wave vector's linear equations z' = A z as an integrator sees them. Columns are independent initial states, so one
/// step over the identity gives the one-step map of any integrator, its histories included.
class ModeSystem final : public abi::System {
public:
    /// A rate cos(omega t) + i sin(omega t) added to a scalar variable.
    struct Forcing {
        int variable;
        double omega;    ///< [rad/s]
    };
    ModeSystem(const Case& scene, const Symbol& symbol, std::optional<Forcing> forcing = {});

    /// The matrix that takes (state, histories that persist) over a step `dt`, past the first step.
    Symbol one_step_map(const abi::Integrator& integrator, double dt);

    /// The n x n matrix that takes the state given at t = 0 to that after `steps` steps, begun as the integrator begins.
    Symbol run_map(const abi::Integrator& integrator, double dt, long steps);

    /// After one_step_map: what the forcing, with the phase that it has when the step begins at t = 0, adds in a step.
    const std::vector<std::complex<double>>& forced() const { return forced_; }
    /// Row of an evolved variable's first component, in the symbol and in the map.
    int row(int variable) const { return first_[std::size_t(variable)]; }

    /// What the last step cost: calls for a rate, and whole evaluations of the equations that they add up to.
    int rate_calls() const { return rate_calls_; }
    double evaluations() const { return evaluations_; }

    int groups() const override { return int(order_.size()); }
    abi::Slot history(const char* name) override;
    void rate(abi::Group group, double t, abi::Slot out) override;
    void advance(abi::Group group, double t, double dt) override;
    void copy(abi::Group group, abi::Slot from, abi::Slot to) override;
    void axpy(abi::Group group, double a, abi::Slot x, abi::Slot y) override;
    void settle(abi::Group, double) override {}

private:
    using Rows = std::vector<std::vector<double>>;    ///< [row][column]
    const Symbol& A_;
    std::optional<Forcing> forcing_;
    std::vector<int> first_;                 ///< row of each evolved variable
    std::vector<std::vector<int>> order_;    ///< rows of each splitting group
    std::vector<std::complex<double>> forced_;
    std::vector<std::size_t> kept_;          ///< rows of the slots, one after the other, that the map acts on
    std::vector<int> all_, none_;
    std::vector<std::string> names_{"state"};
    std::vector<Rows> slots_;

    int rate_calls_ = 0;
    double evaluations_ = 0;

    void count(abi::Group group);
    const std::vector<int>& rows(abi::Group group) const;
    std::vector<double> rate_of(int row, double t) const;
    void unit_slots();
};

}    // namespace sphonic
