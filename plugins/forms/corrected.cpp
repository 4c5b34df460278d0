#include <sphonic/plugin/form.hpp>

/// L_i sum_j V_j (f_j - f_i) grad W_ij: the corrective smoothed particle method of Chen, Beraun and Carney (1999), full
/// matrix. Exact for linear fields on any set. Without an adjoint partner it does not conserve energy on disordered sets.
struct Corrected {
    static constexpr bool uniform = true;
    static constexpr abi::Correction correction = abi::Correction::own;
    static constexpr double own(PairSide, PairSide) { return -1; }
    static constexpr double other(PairSide, PairSide) { return 1; }
};

SPHONIC_FORM("corrected", Corrected, "f_j - f_i with the full-matrix correction (CSPM): exact for linear fields on any set")
