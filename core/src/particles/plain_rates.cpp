#include <algorithm>
#include <cmath>
#include <utility>

#include "plain_pairs.hpp"
#include "stencil.hpp"

namespace sphonic {

std::optional<PlainRates> PlainRates::of(const PairSet& set, const std::vector<Share>& shares) {
    PlainRates rates;
    rates.density = set.density();
    for (const Share& share : shares) {
        if (share.terms.empty()) return std::nullopt;
        for (const Term* term : share.terms)
            if (!rates.add(set, share.variable, *term)) return std::nullopt;
    }
    const bool together = !rates.viscosity || (rates.gradient && (!rates.divergence || rates.divergence->operand == rates.viscosity->operand));
    const bool one_kernel = std::all_of(shares.begin(), shares.end(), [&](const Share& share) {
        return std::all_of(share.terms.begin(), share.terms.end(), [&](const Term* term) { return term->kernel == shares[0].terms[0]->kernel; });
    });
    if (shares.empty() || !together || !one_kernel) return std::nullopt;
    rates.kernel = shares[0].terms[0]->kernel;
    return rates;
}

bool PlainRates::add(const PairSet& set, int target, const Term& term) {
    if (term.op == Term::Operator::viscosity) return !std::exchange(viscosity, &term) && (!gradient || gradient->target == target);
    if (!term.form || !term.fitted.empty() || term.form->correction() != abi::Correction::none) return false;
    auto& place = term.op == Term::Operator::gradient ? gradient : divergence;
    if (place || (term.op == Term::Operator::gradient && viscosity)) return false;    // a viscosity follows its gradient
    place = Derivative{.target = target, .operand = term.operand};
    for (const Factor& factor : term.factors) {
        if (factor.variable != density) return false;
        place->density_power += factor.power;
    }
    place->coefficient = term.coefficient[0] * (density >= 0 ? set.mass : set.volume);
    if (density >= 0 && !term.form->uniform()) {
        place->by_pair = term.form.get();
        return true;
    }
    const RestCoefficients c = rest_coefficients(*term.form, derivative(term), set.scene.medium, set.scene.medium);
    place->own = c.own, place->other = c.other;
    return true;
}

std::vector<int> PlainRates::components_read(const PairSet& set) const {
    std::vector<int> read;
    const auto first = [&](int variable) { return set.components.first[std::size_t(variable)]; };
    for (int a = 0; a < set.scene.box.dimension && vector() >= 0; ++a) read.push_back(first(vector()) + a);
    if (gradient) read.push_back(first(gradient->operand));
    if (density >= 0) read.push_back(first(density));
    return read;
}

}    // namespace sphonic
