#include <sphonic/plugin/form.hpp>

/// sum_j V_j (f_j + f_i) grad W_ij: with the difference divergence it conserves energy on any arrangement.
struct Sum {
    static constexpr bool uniform = true;
    static constexpr double own(PairSide, PairSide) { return 1; }
    static constexpr double other(PairSide, PairSide) { return 1; }
};

SPHONIC_FORM("sum", Sum, "f_j + f_i: pairwise equal and opposite, conserves energy with the difference divergence")
