#pragma once
#include <memory>
#include <span>
#include <vector>

#include <sphonic/case.hpp>
#include <sphonic/plugin/abi/boundary.hpp>

#include "particle_media.hpp"
#include "store.hpp"

namespace sphonic {

class LatticeTiles;

/// Components of the equations' variables in a store: variable v has components first[v] ... ; positions, if any, are last.
struct Components {
    explicit Components(const Case& scene);
    std::vector<int> first;
    int positions = -1;
    int count = 0;

    /// What a component is to the faces of an axis.
    abi::Part part(int component, int axis) const;
    /// Its value in the medium at rest.
    double rest(int component) const { return rest_[std::size_t(component)]; }

private:
    std::vector<int> axis_;    ///< of a vector's component; -1 for scalars
    std::vector<double> rest_;
};

/// Which terms an evaluation takes. Dissipation adds to rates: alone, it does not assign.
enum class Terms { all, without_dissipation, dissipation_only };

/// The state's arrays and where rates go: rate += into `out`, or assigned.
template <class Real>
struct EvaluationOf {
    const Real* const* state;    ///< by component
    Real* const* out;            ///< by component; only those of the program's variables are touched
    double scale = 1;
    bool assign = true;            ///< out = scale * rate, else out += scale * rate
    Terms terms = Terms::all;
};
using Evaluation = EvaluationOf<double>;

/// The rate terms of some variables, made ready for a neighbourhood.
class Program {
public:
    virtual ~Program() = default;
    virtual void evaluate(const Evaluation& evaluation) = 0;
};

/// A neighbourhood: how particles find each other, and how fields are stored for it.
class Tier {
public:
    virtual ~Tier() = default;
    virtual const char* name() const = 0;
    virtual const Layout& layout() const = 0;
    virtual std::unique_ptr<Program> compile(const std::vector<int>& variables) = 0;
    /// Fills what lies beyond the set for one component, with its values at time t [s]; `pressure` is the field of p.
    virtual void fill_ghosts(int component, double* field, const double* pressure, double t) = 0;
    /// A run begins: walls with memory forget.
    virtual void restart() {}
    /// What walls with memory now remember.
    virtual std::vector<std::span<double>> memory() { return {}; }
    /// Positions changed; `x` by axis.
    virtual void moved(const double* const* x) = 0;
    virtual double neighbours_mean() const = 0;
    /// Where particles may stand still: which of them do. Else null.
    virtual LatticeTiles* tiles() { return nullptr; }
    /// How far away the farthest neighbour is, where tiles may stand still [dx].
    virtual double farthest() const { return 0; }
    /// No rate at which fitted weights damp is larger [1/s].
    virtual double damping() const { return 0; }
    virtual double bytes() const = 0;
};

struct Sites;
std::unique_ptr<Tier> make_lattice_tier(const Case& scene, const Components& components, const ParticleMedia& media);
/// `x` by axis, in particle order: those of `sites`, which are kept elsewhere.
std::unique_ptr<Tier> make_list_tier(const Case& scene, const Components& components, const ParticleMedia& media, const Sites& sites, const double* const* x,
                                     bool frozen);

}    // namespace sphonic
