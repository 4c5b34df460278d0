#pragma once
#include <array>
#include <memory>
#include <vector>

#include <sphonic/case.hpp>

#include "store.hpp"
#include "tier.hpp"

namespace sphonic {

/// The state of a particle set and its equations, as integrators see them.
class ParticleSystem final : public abi::System {
public:
    explicit ParticleSystem(const Case& scene);

    int groups() const override { return int(scene_.equations.order.size()); }
    abi::Slot history(const char* name) override { return store_.history(name); }
    void rate(abi::Group group, double t, abi::Slot out) override;
    void advance(abi::Group group, double t, double dt) override;
    void copy(abi::Group group, abi::Slot from, abi::Slot to) override;
    void axpy(abi::Group group, double a, abi::Slot x, abi::Slot y) override;
    void settle(abi::Group group, double t) override;

    /// Initial state at t = 0: the case's initial fields, sources' pressure and velocity, everything else at rest.
    void initialise();

    const Tier& tier() const { return *tier_; }
    const Layout& layout() const { return tier_->layout(); }
    long particles() const { return layout().particles(); }
    /// Field of a component in a slot, in the tier's layout.
    const double* field(int component, abi::Slot slot = abi::state) { return store_.array(slot, component); }
    const Components& components() const { return components_; }
    bool moving() const { return components_.positions >= 0; }
    /// Coordinate of each particle by axis, in particle order.
    std::array<const double*, 3> positions();
    double bytes() const;
    /// Largest |eigenvalue| of the assembled, linearised operator [1/s] by power iteration on its square, from below.
    /// For sets with a neighbour list; leaves the fields zero.
    double largest_frequency(int iterations);
    /// The rate of one variable's component 0 ... into a named slot, without changing the state.
    void rate_of(int variable, double t, abi::Slot out);

private:
    /// A source's particles and room for its values.
    struct Members {
        const abi::Source* source;
        std::vector<std::ptrdiff_t> at;       ///< in the field
        std::vector<double> x[3], p, u[3];
    };
    /// What a group stands for: variables with their program, and whether positions go along.
    struct Part {
        std::vector<int> variables;
        std::vector<int> components;
        bool positions = false;
        bool reads_itself = true;    ///< a term reads what the group advances: the rate needs an array of its own
        std::unique_ptr<Program> program;
    };

    const Case& scene_;
    Components components_;
    std::vector<double> x_[3];    ///< initial positions; of frozen sets, for good
    std::unique_ptr<Tier> tier_;
    Store store_;
    std::vector<Part> parts_;     ///< by splitting group, then everything, fields, positions
    std::vector<Members> members_;
    int pressure_, velocity_;       ///< the variables p and u
    std::vector<int> algebraic_;    ///< in order of evaluation
    std::vector<const double*> state_arrays_;
    std::vector<double*> out_arrays_;

    int evolved_behind(int variable) const;    ///< itself, if it is evolved
    void order_algebraic();
    void place_particles();
    void displace(double* const* x) const;
    void make_parts();
    Part make_part(std::vector<int> variables, bool positions);
    bool reads(const Part& part) const;
    void enlist_sources();
    Part& part(abi::Group group);
    void evaluate(Part& part, abi::Slot out, double scale, bool assign);
    void impose(Members& members, double t, bool pressure, bool velocity);
    void set_scalar(int variable, const std::vector<std::ptrdiff_t>& at, std::vector<double>& value);
    void set_initial_fields();
    void refresh_algebraic(const Part& changed);
};

}    // namespace sphonic
