#pragma once
#include <memory>
#include <string>
#include <vector>

#include <sphonic/case.hpp>
#include <sphonic/plugin/energy_budget.hpp>

#include "group_parts.hpp"
#include "lattice_ghosts.hpp"
#include "lattice_operators.hpp"
#include "lattice_terms.hpp"
#include "particle_layers.hpp"
#include "sites.hpp"
#include "source_members.hpp"

namespace sphonic {

/// A lattice's derivatives, sources, walls and layers with fields of half the width: half the memory and twice the values in a
/// vector. Weights, places, times and what sources give are of double precision until they meet a field. All particles are stepped.
class SingleSystem final : public abi::System {
public:
    /// Throws where the case has what needs double precision.
    explicit SingleSystem(const Case& scene);

    int groups() const override { return int(scene_.equations.order.size()); }
    abi::Slot history(const char* name) override { return store_.history(name); }
    void rate(abi::Group group, double t, abi::Slot out) override;
    void advance(abi::Group group, double t, double dt) override;
    void copy(abi::Group group, abi::Slot from, abi::Slot to) override;
    void axpy(abi::Group group, double a, abi::Slot x, abi::Slot y) override;
    void settle(abi::Group group, double t) override;

    void initialise(double dt);
    /// Walls with memory begin with the present state.
    void forget_walls();
    /// To be called after every step, which ends at t.
    void close_step(double t, double dt);
    /// The rate of one variable into a slot, without changing the state.
    void rate_of(int variable, double t, abi::Slot out);

    const Layout& layout() const { return grid_.layout; }
    long particles() const { return layout().particles(); }
    const float* field(int component, abi::Slot slot = abi::state) { return store_.array(slot, component); }
    double value(const char* variable, long particle);
    const ParticleMedia& media() const { return media_; }
    int medium_of_source(std::size_t i) const { return sources_[i].media()[0]; }
    const Components& components() const { return components_; }
    std::array<const double*, 3> positions() const;
    void start_budget(double energy) { budget_.start(energy); }
    const EnergyBudget& budget() const { return budget_; }
    void let_sleep(const StepFacts&) {}
    abi::Activity activity() const { return {.all_because = "fields of single precision are stepped whole"}; }
    const char* tier_name() const { return "lattice, single precision"; }
    double neighbours_mean() const { return grid_.neighbours_mean(); }
    double bytes() const;

private:
    struct Part : GroupParts {
        std::unique_ptr<LatticeTerms<float>> terms;
    };
    const Case& scene_;
    Components components_;
    std::vector<double> x_[3];
    ParticleMedia media_;
    LatticeGrid grid_;
    LatticeGhosts ghosts_;
    StoreOf<float> store_;
    std::vector<Part> parts_;
    std::vector<SourceMembers> sources_;
    std::vector<Damped> layers_;
    int pressure_, velocity_;    ///< the variables p and u
    double supply_ = 0;          ///< energy of the largest rate that sources added within a step
    EnergyBudget budget_;
    std::vector<const float*> state_;
    std::vector<float*> out_;

    SingleSystem(const Case& scene, const Sites& sites);
    Part make_part(GroupParts parts) const;
    Part& part(abi::Group group) { return parts_[GroupParts::number(group, groups())]; }
    void evaluate(Part& part, double t, abi::Slot out, double scale, bool assign);
    void add_sources(const Part& part, double t, abi::Slot out, double scale);
    void impose(SourceMembers& source, double t, bool pressure, bool velocity);
    int first(int variable) const { return components_.first[std::size_t(variable)]; }
    const abi::Medium& medium(const SourceMembers& source, std::size_t i) const { return media_.list()[std::size_t(source.media()[i])]; }
};

}    // namespace sphonic
