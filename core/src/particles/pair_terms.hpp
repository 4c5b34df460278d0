#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "pair_correction.hpp"

namespace sphonic {

/// Rate terms as one scalar per pair of a tile, which multiplies r_ij where the term is a vector; a corrected gradient as
/// one per axis. For one thread.
class PairTerms {
public:
    /// By kernel, null where no form asks for them.
    using Corrections = std::vector<std::unique_ptr<PairCorrections>>;
    PairTerms(const PairSet& set, const Corrections& corrections)
        : set_(set), corrections_(corrections), corrected_(corrections.size()) {}

    static bool corrected_gradient(const Term& term) {
        return term.op == Term::Operator::gradient && term.form->correction() != abi::Correction::none;
    }

    void start(const PairTile& tile, PairValues& pairs);
    /// Any other term, assigned or added.
    void add(const Term& term, PairValues& pairs, double* sum, bool assign);
    /// One axis of a corrected gradient without its coefficient and V_j (dW/dr)/r.
    const double* gradient(const Term& term, PairValues& pairs, int axis);

private:
    /// Per-pair coefficients; a stride of 0 stands for a uniform one.
    struct Coefficient {
        const double* value;
        int stride;
    };
    const PairSet& set_;
    const Corrections& corrections_;
    std::vector<CorrectedSeparations> corrected_;
    Array density_, own_, other_, u_dot_r_, Pi_, value_, impedance_i_, impedance_j_;

    int component(int v) const { return set_.components.first[std::size_t(v)]; }
    std::pair<Coefficient, Coefficient> coefficients(const Term& term, PairValues& pairs);
    void add_derivative(const Term& term, PairValues& pairs, double* sum, bool assign);
    void add_viscosity(const Term& term, PairValues& pairs, double* sum, bool assign);
    void combine(const Term& term, PairValues& pairs, int axis, double* value);
    void multiply(double* value, PairValues& pairs, const Factor& factor) const;
};

}    // namespace sphonic
