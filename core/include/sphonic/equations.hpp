#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include <sphonic/plugin/abi/dissipation.hpp>
#include <sphonic/plugin/abi/form.hpp>
#include <sphonic/plugin/abi/kernel.hpp>
#include <sphonic/plugin/abi/state.hpp>
#include <sphonic/plugin/abi/viscosity.hpp>

namespace sphonic {

/// A kernel in use: the plugin and its smoothing length [m].
struct KernelUse {
    std::string name;    ///< empty for the default kernel, else its key in "kernels"
    std::unique_ptr<abi::Kernel> kernel;
    double h = 0;

    double radius() const { return kernel->support() * h; }
};

/// An integer power of a scalar variable.
struct Factor {
    int variable;
    int power;
};

/// Weights that a form brings itself, for one of each pair of a lattice's neighbours: f_j takes w o / dx at o, the opposite at -o.
struct LatticeWeights {
    std::vector<std::array<int, 3>> offset;    ///< in spacings
    std::vector<double> weight;
};

/// One rate term: coefficient of the medium * (product of factors) * operator.
struct Term {
    enum class Operator { divergence, gradient, viscosity, dissipation } op;
    int operand = -1;                            ///< variable the operator acts on (its own, for viscosity and dissipation)
    std::unique_ptr<abi::Form> form{};             ///< for divergence and gradient
    std::string form_text{};                       ///< as the case gives it: equal texts are equal forms
    std::unique_ptr<abi::Viscosity> viscosity{};
    std::shared_ptr<const abi::Dissipation> dissipation{};    ///< its strength alpha is the coefficient
    int kernel = 0;                              ///< index into the kernels of the case
    std::vector<double> coefficient{1};          ///< by medium
    std::vector<Factor> factors{};
    /// By medium, where the form has weights of its own; on a cloud they are those of its lattice, by which it is judged.
    std::vector<std::shared_ptr<const LatticeWeights>> fitted{};
    double cancelled = 0;                        ///< c0 dt/dx of the leapfrog whose error in time a cloud's weights cancel; 0 for others
};

/// A variable of the equations: evolved by a sum of terms, or algebraic in another variable.
struct Variable {
    std::string name;
    bool is_vector = false;
    std::vector<Term> terms{};
    std::unique_ptr<abi::State> state{};    ///< algebraic when set
    int of = -1;                          ///< its argument

    bool evolved() const { return !state; }
    int components(int dimension) const { return is_vector ? dimension : 1; }
};

/// The assembled equations of a case.
struct Equations {
    std::vector<Variable> variables;
    /// Splitting groups as indices of evolved variables; `positions_group` is the one that also moves x, or -1.
    std::vector<std::vector<int>> order;
    int positions_group = -1;
    int velocity = -1;    ///< the variable that moves x
    int density = -1;     ///< the variable rho, if the equations have one: then V_j = m_j / rho_j on moving sets

    /// -1 if there is none of that name.
    int find(const std::string& name) const;
    /// True if some term is a dissipation.
    bool dissipate() const;
};

}    // namespace sphonic
