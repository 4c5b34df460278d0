#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <sphonic/case.hpp>
#include <sphonic/plugin/abi/method.hpp>
#include <sphonic/plugin/energy_budget.hpp>

#include "group_parts.hpp"
#include "particle_layers.hpp"
#include "sites.hpp"
#include "source_members.hpp"
#include "store.hpp"
#include "tier.hpp"
#include "wake.hpp"
#include "wall_flow.hpp"
#include "wall_smoothing.hpp"

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
    void initialise(double dt);
    /// The present state is that of t = 0: walls with memory begin with it.
    void forget_walls();
    /// From now on, what no sound has reached stands still, and what can no longer matter to what is asked for. Before the first step.
    void let_sleep(const StepFacts& step);
    abi::Activity activity() const;

    const char* tier_name() const { return tier_->name(); }
    double neighbours_mean() const { return tier_->neighbours_mean(); }
    /// No rate at which fitted weights damp is larger [1/s].
    double damping() const { return tier_->damping(); }
    const Layout& layout() const { return tier_->layout(); }
    long particles() const { return layout().particles(); }
    /// Field of a component in a slot, in the tier's layout.
    const double* field(int component, abi::Slot slot = abi::state) { return store_.array(slot, component); }
    /// Of the first component of a variable, at a particle in their order.
    double value(const char* variable, long particle);
    const ParticleMedia& media() const { return media_; }
    /// That of its first particle.
    int medium_of_source(std::size_t i) const { return sources_[i].media()[0]; }
    const Components& components() const { return components_; }
    bool moving() const { return components_.positions >= 0; }
    /// Coordinate of each particle by axis, in particle order.
    std::array<const double*, 3> positions();
    double bytes() const;
    /// Begins to account for what sources supply, from this energy on.
    void start_budget(double energy) { budget_.start(energy); }
    /// To be called after every step, which ends at t.
    void close_step(double t, double dt);
    const EnergyBudget& budget() const { return budget_; }
    /// Largest |eigenvalue| of the assembled, linearised operator [1/s], from below; with dissipation, the largest sum of a frequency
    /// and a rate of decay. Leaves the fields zero.
    double largest_frequency();
    /// Length of a linear state: values over (component, particle).
    long values();
    /// What one unit of a value in a linear state is: states are differences from rest in units of the medium, rho0 c0^2 of
    /// pressure and c0 of velocity.
    double unit(long value);
    /// y = A x for linear states and the equations' operator linearised at rest, dissipation times `dissipation`. Viscosity acts at half
    /// strength: A x is the odd part of the rates at a small x. Sources are left out. Changes the fields.
    void linear_rate(const double* x, double* y, double dissipation);
    /// Begins anew with a linear state times `size` on top of the initial fields; no history is left.
    void begin_with(const double* x, double size, double dt);
    /// All that a step depends on: every array of every slot with its ghosts, and what walls remember.
    std::vector<std::span<double>> everything();
    /// Sum of squares of the present state's values, as a linear state.
    double squares();
    /// The rate of one variable's component 0 ... into a named slot, without changing the state.
    void rate_of(int variable, double t, abi::Slot out);

private:
    struct Part : GroupParts {
        std::unique_ptr<Program> program;
    };

    const Case& scene_;
    Components components_;
    int threads_;
    std::vector<double> x_[3];    ///< initial positions; of frozen sets, for good
    ParticleMedia media_;
    std::unique_ptr<Tier> tier_;
    Store store_;
    std::vector<Part> parts_;     ///< by splitting group, then everything, fields, positions
    std::vector<SourceMembers> sources_;
    std::vector<Damped> layers_;
    double damping_step_ = 0;    ///< that the factors are for [s]
    std::unique_ptr<WallSmoothing> smoothing_;    ///< where obstacles have walls
    WallFlow flow_;                               ///< into walls that give way
    double supply_ = 0;    ///< energy of the largest rate that sources added within a step
    int pressure_, velocity_;       ///< the variables p and u
    Case::Behind of_pressure_;      ///< what p is computed from
    bool supplied_ = false;         ///< a source adds to rates
    EnergyBudget budget_;
    std::vector<int> algebraic_;    ///< in order of evaluation
    std::unique_ptr<Wake> wake_;        ///< where some particles may stand still
    std::string all_because_;           ///< why none may
    long planned_[2] = {0, 0};          ///< evaluations of the first step and of any other
    long evaluations_ = 0, steps_done_ = 0;
    std::vector<const double*> state_arrays_;
    std::vector<double*> out_arrays_;

    double unit_of(int component) const;
    void set_linear(const double* x, double size, bool add);

    int evolved_behind(int variable) const { return scene_.behind(variable).variable; }
    void order_algebraic();
    ParticleSystem(const Case& scene, const Sites& sites);
    void make_parts();
    Part make_part(GroupParts parts);
    Part& part(abi::Group group);
    void evaluate_terms(Part& part, abi::Slot out, double scale, bool assign, Terms terms = Terms::all);
    void evaluate(Part& part, double t, abi::Slot out, double scale, bool assign);
    void move(abi::Slot out, double scale, bool assign);
    void add_sources(const Part& part, double t, abi::Slot out, double scale);
    void impose(SourceMembers& members, double t, bool pressure, bool velocity);
    void set_scalar(int variable, const std::vector<std::ptrdiff_t>& at, std::vector<double>& value);
    void put(const std::vector<std::ptrdiff_t>& at, const std::vector<double>& value, int component);
    class Spectrum;    ///< in particle_spectrum.cpp
    static double lanczos(Spectrum& spectrum, abi::Slot v, abi::Slot w, abi::Slot before);
    static double power(Spectrum& spectrum, abi::Slot v, abi::Slot w);
    void damp(double dt);
    void treat_pressure(double t, double dt);
    /// That of a source's i-th particle.
    const abi::Medium& medium(const SourceMembers& source, std::size_t i) const { return media_.list()[std::size_t(source.media()[i])]; }
    double at_rest(int variable) const;
    std::string restless() const;
    std::vector<char> asked_for() const;
    long through_walls() const;
    double contrast() const;
    void note_evaluation(const Part& part);
    void watch_step();
    /// Calls block(begin, end) over the places in a field of what is stepped.
    template <class Block>
    void in_stepped(Block block) const;
    void set_initial_fields();
    void refresh_algebraic(const Part& changed, double t);
};

}    // namespace sphonic
