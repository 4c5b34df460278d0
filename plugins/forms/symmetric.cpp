#include <sphonic/plugin/form.hpp>

/// rho_i sum_j m_j (f_i / rho_i^2 + f_j / rho_j^2) grad W_ij, with m_j = rho_j V_j: conserves momentum where densities vary.
struct Symmetric {
    static constexpr double own(PairSide i, PairSide j) { return j.rho * i.inverse_rho; }
    static constexpr double other(PairSide i, PairSide j) { return i.rho * j.inverse_rho; }
};

SPHONIC_FORM("symmetric", Symmetric, "f_i/rho_i^2 + f_j/rho_j^2: conserves momentum where densities vary")
