#include <sphonic/plugin/form.hpp>

/// sum_j V_j (f_j - f_i) grad W_ij: exact for constants. As a divergence it is minus the adjoint of the sum gradient.
struct Difference {
    static constexpr bool uniform = true;
    static constexpr double own(PairSide, PairSide) { return -1; }
    static constexpr double other(PairSide, PairSide) { return 1; }
};

SPHONIC_FORM("difference", Difference, "f_j - f_i: exact for constants")
