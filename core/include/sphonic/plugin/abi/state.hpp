#pragma once

namespace sphonic::abi {

/// Rest state of the medium.
struct Medium {
    double c0 = 340;      ///< sound speed [m/s]
    double rho0 = 1.2;    ///< density [kg/m^3]
};

/// An algebraic variable y = f(x), refreshed before use: equations of state and their like.
class State {
public:
    static constexpr const char* kind = "state";
    virtual ~State() = default;

    /// y for n values of x.
    virtual void evaluate(const Medium& medium, int n, const double* x, double* y) const = 0;
    /// x for n values of y, so that an imposed pressure also fixes what it is computed from.
    virtual void invert(const Medium& medium, int n, const double* y, double* x) const = 0;
    /// dy/dx at x: the linearised equations need it.
    virtual double derivative(const Medium& medium, double x) const = 0;
};

}    // namespace sphonic::abi
