#include <sphonic/plugin/viscosity.hpp>

/// Monaghan and Gingold (1983), for approaching pairs only (u_ij . r_ij < 0):
///   Pi_ij = (-alpha c_ij phi_ij + beta phi_ij^2) / rho_ij,   phi_ij = h_ij u_ij . r_ij / (r_ij^2 + (0.1 h_ij)^2)
struct Monaghan {
    double alpha = 0.06, beta = 0.5;

    static constexpr auto parameters() {
        return std::array{
            real("alpha", &Monaghan::alpha, "1", 0, 10, "linear coefficient: bulk and shear damping"),
            real("beta", &Monaghan::beta, "1", 0, 10, "quadratic coefficient: keeps strong shocks from penetrating")};
    }

    struct Pair {
        double linear, quadratic;    ///< of u_ij . r_ij
    };
    Pair prepare(double r2, double h, double c, double rho) const {
        const double width = r2 + 0.01 * h * h, inverse = 1 / (width * rho);    // one division: phi = h u.r / width
        return {-alpha * c * h * inverse, beta * h * h * inverse * inverse * rho};
    }
    double operator()(const Pair& pair, double u_dot_r) const {
        const double s = std::min(u_dot_r, 0.0);
        return (pair.linear + pair.quadratic * s) * s;
    }
};

SPHONIC_VISCOSITY("monaghan", Monaghan, "Monaghan-Gingold artificial viscosity for approaching pairs")
