#include <sphonic/plugin/viscosity.hpp>

/// Pi_ij = -alpha c_ij h_ij min(u_ij . r_ij, 0) / (rho_ij (r_ij^2 + 0.01 h_ij^2)): the linear part of Monaghan's.
struct OutsideLinear {
    double alpha = 0.1;

    static constexpr auto parameters() {
        return std::array{real("alpha", &OutsideLinear::alpha, "1", 0, 10, "linear coefficient")};
    }
    struct Pair {
        double linear;
    };
    Pair prepare(double r2, double h, double c, double rho) const { return {-alpha * c * h / (rho * (r2 + 0.01 * h * h))}; }
    double operator()(const Pair& pair, double u_dot_r) const { return pair.linear * std::min(u_dot_r, 0.0); }
};

SPHONIC_VISCOSITY("outside_linear", OutsideLinear, "Linear viscosity, built outside sphonic's tree")
