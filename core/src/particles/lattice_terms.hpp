#pragma once
#include <memory>
#include <vector>

#include "lattice_operators.hpp"

namespace sphonic {

/// The rate terms of some variables on a lattice.
template <class Real>
class LatticeTerms {
public:
    LatticeTerms(const LatticeGrid& grid, const Components& components, const std::vector<int>& variables) : grid_(grid) {
        for (const int v : variables) {
            const Variable& variable = grid.scene.equations.variables[std::size_t(v)];
            std::vector<int> target;
            for (int c = 0; c < variable.components(grid.scene.box.dimension); ++c)
                target.push_back(components.first[std::size_t(v)] + c);
            if (variable.terms.empty()) still_.insert(still_.end(), target.begin(), target.end());
            for (std::size_t t = 0; t < variable.terms.size(); ++t)
                operators_.push_back({make_lattice_term<Real>(grid, components, variable.terms[t], target), t == 0});
        }
    }

    void evaluate(const EvaluationOf<Real>& e) {
        if (e.assign)
            for (const int c : still_) std::fill_n(e.out[c], grid_.layout.size, Real(0));
        for (const auto& [op, first] : operators_) {
            EvaluationOf<Real> share = e;
            share.assign = e.assign && first;
            op->apply(share);
        }
    }

private:
    struct Entry {
        std::unique_ptr<LatticeTerm<Real>> op;
        bool first;    ///< of its variable: assigns where the others add
    };
    const LatticeGrid& grid_;
    std::vector<Entry> operators_;
    std::vector<int> still_;
};

}    // namespace sphonic
