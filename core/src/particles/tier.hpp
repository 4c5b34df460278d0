#pragma once
#include <memory>
#include <vector>

#include <sphonic/case.hpp>

#include "store.hpp"

namespace sphonic {

/// Components of the equations' variables in a store: variable v has components first[v] ... ; positions, if any, are last.
struct Components {
    explicit Components(const Equations& equations, int dimension, bool moving);
    std::vector<int> first;
    int positions = -1;
    int count = 0;
};

/// The state's arrays and where rates go: rate += into `out`, or assigned.
struct Evaluation {
    const double* const* state;    ///< by component
    double* const* out;            ///< by component; only those of the program's variables are touched
    double scale = 1;
    bool assign = true;            ///< out = scale * rate, else out += scale * rate
};

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
    /// Fills what lies beyond the set (periodic images) of one field.
    virtual void fill_ghosts(double* field) const = 0;
    /// Positions changed; `x` by axis.
    virtual void moved(const double* const* x) = 0;
    virtual double neighbours_mean() const = 0;
    virtual double bytes() const = 0;
};

std::unique_ptr<Tier> make_lattice_tier(const Case& scene, const Components& components);
/// `x` by axis, in particle order.
std::unique_ptr<Tier> make_list_tier(const Case& scene, const Components& components, const double* const* x, bool frozen);

}    // namespace sphonic
