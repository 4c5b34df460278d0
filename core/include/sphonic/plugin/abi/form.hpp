#pragma once
#include <memory>

namespace sphonic::abi {

/// What a form weighs the values of: a scalar for its gradient, a vector for its divergence.
enum class Derivative : int { gradient, divergence };

/// The two particles of each of n pairs: densities [kg/m^3], their inverses, which cost a division less, and impedances
/// rho c [Pa s/m].
struct PairMedia {
    int n = 0;
    const double *rho_i = nullptr, *rho_j = nullptr;
    const double *inverse_rho_i = nullptr, *inverse_rho_j = nullptr;
    const double *impedance_i = nullptr, *impedance_j = nullptr;
};

/// Which kernel gradients the two values of a pair are weighed with, where
///   L_i = [ sum_j V_j grad_i W_ij (x) (x_j - x_i) ]^-1
/// makes the difference form exact for linear fields on any set (Chen, Beraun, Carney 1999; full matrix).
enum class Correction : int {
    none,       ///< grad W for both
    own,        ///< L_i grad W for both
    pairwise    ///< L_i grad W for f_i and L_j grad W for f_j: the adjoint of `own`
};

/// The neighbours of a particle in the interior of a lattice, one of each pair o, -o, for a form that brings weights of its own.
struct LatticeFit {
    int dimension = 1;
    int n = 0;
    const int* offset[3] = {nullptr, nullptr, nullptr};    ///< o by axis, in spacings
    /// c0 dt/dx of the leapfrog whose error in time the weights are to cancel; 0: of none.
    double courant = 0;
    /// The largest |F| dx that the integrator bears at the step of the run, F being the operator's symbol; infinity if not known.
    double most = 0;
};

/// The n neighbours of one particle of a cloud, a set without structure, for a form that brings weights of its own.
struct CloudNeighbours {
    int n = 0;
    const double* offset[3] = {nullptr, nullptr, nullptr};    ///< x_j - x_i by axis, in spacings
};

/// What a form weighs the differences f_j - f_i of such a neighbourhood with.
struct CloudWeights {
    double* gradient[3] = {nullptr, nullptr, nullptr};    ///< by axis and neighbour: other_ij V_j grad_i W_ij becomes other_ij w_ij / dx
    /// Every variable f with such a derivative also gets df_i/dt += c0/dx sum_j d_ij (f_j - f_i): damping of what the weights do
    /// not carry, without which disorder makes it grow.
    double* damping = nullptr;
};

/// Fits weights to one neighbourhood after another, in many threads at once.
class CloudFit {
public:
    virtual ~CloudFit() = default;
    /// False, and nothing of use written, if the neighbours determine no weights.
    virtual bool fit(const CloudNeighbours& neighbours, const CloudWeights& weights) const = 0;
};

/// How a gradient or a divergence weighs the two values of a pair:
///   sum_j V_j (own_ij f_i + other_ij f_j) grad_i W_ij      (dot product for a divergence).
/// The form decides what is conserved and what converges.
class Form {
public:
    static constexpr const char* kind = "form";
    virtual ~Form() = default;

    virtual Correction correction() const { return Correction::none; }
    /// True when the two coefficients are the same for every pair and every medium; they are then asked for once.
    virtual bool uniform() const = 0;
    virtual void coefficients(Derivative derivative, const PairMedia& media, double* own, double* other) const = 0;

    /// Radius of a form's own weights in spacings; 0 for the others, which take the kernel's gradient.
    virtual double reach() const { return 0; }
    /// Those weights on a lattice: other_ij V_j grad_i W_ij becomes other_ij w_o o / dx, and the opposite for -o.
    /// Throws std::invalid_argument with a remedy if there are none.
    virtual void fit(const LatticeFit&, double*) const {}

    /// Radius of such weights on a cloud, in spacings; 0 if a form has them on lattices only.
    virtual double cloud_reach(int /*dimension*/) const { return 0; }
    /// Those weights in a medium where c0 dt/dx of the leapfrog, whose error in time they are to cancel, is `courant`; 0: of none.
    virtual std::unique_ptr<CloudFit> cloud_fit(int /*dimension*/, double /*courant*/) const { return nullptr; }
};

}    // namespace sphonic::abi
