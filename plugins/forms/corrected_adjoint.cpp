#include <sphonic/plugin/form.hpp>

/// sum_j V_j (L_i f_i + L_j f_j) grad W_ij: minus the adjoint of the corrected form, so that a corrected divergence and this
/// gradient conserve energy on any set.
struct CorrectedAdjoint {
    static constexpr bool uniform = true;
    static constexpr abi::Correction correction = abi::Correction::pairwise;
    static constexpr double own(PairSide, PairSide) { return 1; }
    static constexpr double other(PairSide, PairSide) { return 1; }
};

SPHONIC_FORM("corrected_adjoint", CorrectedAdjoint, "L_i f_i + L_j f_j: conserves energy with the corrected divergence")
