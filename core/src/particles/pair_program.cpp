#include <algorithm>

#include "pair_dissipation.hpp"
#include "pair_terms.hpp"
#include "parallel.hpp"

namespace sphonic {
namespace {

/// What terms read, by places in the state.
std::vector<int> components_read(const PairSet& set, const std::vector<Share>& shares) {
    const Equations& e = set.scene.equations;
    std::vector<int> read;
    const auto add = [&](int v) {
        for (int c = 0; c < e.variables[std::size_t(v)].components(set.scene.box.dimension); ++c)
            read.push_back(set.components.first[std::size_t(v)] + c);
    };
    if (set.density() >= 0) add(set.density());
    for (const Share& share : shares)
        for (const Term* term : share.terms) {
            add(term->operand);
            for (const Factor& f : term->factors) add(f.variable);
        }
    std::sort(read.begin(), read.end());
    read.erase(std::unique(read.begin(), read.end()), read.end());
    return read;
}

/// Rate terms tile by tile, every term as one scalar per pair. One worker per thread.
class PairWorker {
public:
    PairWorker(const PairSet& set, const std::vector<Share>& shares, const PairFields& fields, const PairTerms::Corrections& corrections)
        : set_(set), shares_(shares), pairs_(set, fields), terms_(set, corrections) {}

    /// Tiles begin ... end - 1.
    void evaluate(const Evaluation& e, long begin, long end) {
        for (long i = begin; i < end; ++i) {
            take_tile(set_, i, tile_);
            pairs_.start(tile_);
            terms_.start(tile_, pairs_);
            for (const Share& share : shares_) evaluate_share(share, e);
        }
    }

private:
    const PairSet& set_;
    std::vector<Share> shares_;
    PairValues pairs_;
    PairTile tile_;
    PairTerms terms_;
    Array sum_;

    const Variable& variable(int v) const { return set_.scene.equations.variables[std::size_t(v)]; }

    /// All terms of a variable that one scalar per pair times r_ij can hold, and then the others.
    void evaluate_share(const Share& share, const Evaluation& e) {
        double* sum = pairs_.room(sum_);
        const int d = set_.scene.box.dimension, target = set_.components.first[std::size_t(share.variable)];
        bool empty = true, assign = e.assign;
        for (const Term* term : share.terms) {
            if (PairTerms::corrected_gradient(*term)) continue;
            terms_.add(*term, pairs_, sum, empty);
            empty = false;
        }
        if (share.terms.empty()) std::fill_n(sum, tile_.n, 0.0);
        if (!variable(share.variable).is_vector) return row_sums(tile_, sum, e.scale, e.assign, e.out[target]);
        for (int a = 0; (!empty || share.terms.empty()) && a < d; ++a) {
            row_sums(tile_, sum, pairs_.r(a), e.scale, e.assign, e.out[target + a]);
            assign = false;
        }
        for (const Term* term : share.terms) {
            if (!PairTerms::corrected_gradient(*term)) continue;
            for (int a = 0; a < d; ++a)
                row_sums(tile_, terms_.gradient(*term, pairs_, a), pairs_.weight(term->kernel), e.scale * term->coefficient[0], assign, e.out[target + a]);
            assign = false;
        }
    }
};

class PairProgram final : public Program {
public:
    PairProgram(const PairSet& set, std::vector<Share> shares) : set_(set), corrections_(set.scene.kernels.size()) {
        for (Share& share : shares) {
            for (const Term* term : share.terms) {
                auto& corrections = corrections_[std::size_t(term->kernel)];
                const bool corrected = term->form && term->form->correction() != abi::Correction::none;
                if (!corrections && (corrected || term->dissipation)) corrections = std::make_unique<PairCorrections>(set, term->kernel);
                if (corrected && term->form->correction() == abi::Correction::pairwise) corrections->pairwise();
                if (term->dissipation) dissipations_.push_back(std::make_unique<PairDissipation>(set, *term, *corrections));
            }
            std::erase_if(share.terms, [](const Term* term) { return term->dissipation != nullptr; });
        }
        fields_ = std::make_unique<PairFields>(set, components_read(set, shares));
        for (int t = 0; t < set.threads; ++t) workers_.emplace_back(set, shares, *fields_, corrections_);
        if (set.density() >= 0) inverse_rho_ = Array(std::size_t(set.layout.size));
    }

    void evaluate(const Evaluation& e) override {
        if (inverse_rho_.data()) invert(set_.threads, set_.layout.size, e.state[set_.components.first[std::size_t(set_.density())]], inverse_rho_.data());
        for (const auto& corrections : corrections_)
            if (corrections) corrections->compute(inverse_rho_.data());
        if (e.terms != Terms::dissipation_only) evaluate_shares(e);
        if (e.terms == Terms::without_dissipation) return;
        for (const auto& dissipation : dissipations_) dissipation->apply(e, inverse_rho_.data());
    }

private:
    const PairSet& set_;
    PairTerms::Corrections corrections_;
    std::unique_ptr<PairFields> fields_;
    std::vector<PairWorker> workers_;
    std::vector<std::unique_ptr<PairDissipation>> dissipations_;
    Array inverse_rho_;

    void evaluate_shares(const Evaluation& e) {
        const long n = tiles(set_), threads = set_.threads;
        fields_->fill(e.state, inverse_rho_.data());
        in_parallel(set_.threads, threads, [&](long t) {
            workers_[std::size_t(t)].evaluate(e, n * t / threads, n * (t + 1) / threads);
        });
    }
};

}    // namespace

std::vector<Share> whole_shares(const Equations& equations, const std::vector<int>& variables) {
    std::vector<Share> shares;
    for (const int v : variables) {
        shares.push_back({v, {}});
        for (const Term& term : equations.variables[std::size_t(v)].terms) shares.back().terms.push_back(&term);
    }
    return shares;
}

std::unique_ptr<Program> make_pair_program(const PairSet& set, const std::vector<Share>& shares) {
    return std::make_unique<PairProgram>(set, shares);
}

}    // namespace sphonic
