#pragma once
#include <complex>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sphonic/case.hpp>

namespace sphonic {

/// The equations of a case, linearised at rest on its infinite lattice, for one wave vector:
/// z' = A z for z = (scalars, vectors / i), a real matrix, row-major, n x n.
struct Symbol {
    int n = 0;
    std::vector<double> a;
};

/// What of the damping terms enters, as factors. Viscosity counts as always switched on.
struct Damping {
    double viscosity = 1, dissipation = 1;
};
inline constexpr Damping undamped{0, 0};

/// The equations of a case on its infinite lattice, in one of its media, made ready for many wave vectors.
class LatticeOperator {
public:
    struct Part;

    explicit LatticeOperator(const Case& scene, int medium = 0);
    ~LatticeOperator();

    /// `k` [rad/m] has `dimension` entries.
    Symbol symbol(const double* k, Damping damping = {}) const;
    /// omega(k)/c0 [rad/m] along `direction` (unit vector): the largest frequency at that wave vector, undamped; c0 of the first medium.
    double dispersion(double k, const double* direction) const;
    /// Speed of a long wave along `direction`, over c0: the limit of omega/(c0 k) for k -> 0, undamped.
    double long_wave_speed(const double* direction) const;

private:
    const Case& scene_;
    int n_ = 0;
    std::vector<Part> parts_;
};

/// The same for a single wave vector.
Symbol symbol(const Case& scene, const double* k, Damping damping = {}, int medium = 0);

/// In the first medium.
double long_wave_speed(const Case& scene, const double* direction);

double dispersion(const Case& scene, double k, const double* direction);

/// The equations of a case on its own particles, linearised at rest, over (component, particle): z' = A z with the dissipation times
/// `dissipation`, and viscosity at half strength, the odd part of one that acts on approaching pairs only. Dense: for some hundred particles.
Symbol assembled(const Case& scene, double dissipation = 1);
/// Stability of a set: none may have a positive real part.
std::vector<std::complex<double>> eigenvalues(const Symbol& matrix);

/// Largest |eigenvalue| of the one-step map of the case's integrator over the sampled wave vectors, in the most demanding medium.
double amplification(const Case& scene, double dt);

struct StepLimit {
    double dt = 0;         ///< largest stable step [s]; 0 where growth cannot be kept small by any useful step
    double frequency = 0;  ///< largest of the operator's over the zone [1/s]
    bool weak = false;     ///< the integrator grows at any step: dt is where the worst mode grows by e^12 within `until`
    double mild = 0;       ///< of a weak one: where the worst mode grows by e within `until` [s]
};
inline constexpr double weak_exponent = 12;    ///< growth over the run that a weakly unstable integrator may reach

/// The largest omega dt that the case's integrator bears for an undamped oscillation of p and u; 0 where it grows at any step.
double oscillator_limit(const Case& scene);

/// The largest dt (omega + delta) that the case's integrator bears for oscillations of p and u of every ratio of their rate of decay
/// delta > 0 to their frequency omega.
double decaying_limit(const Case& scene);

/// The largest stable step of the case on its lattice, with viscosity always on and without any, in the most demanding medium. Dissipation counts where
/// the particles are on that lattice.
StepLimit step_limit(const Case& scene);

/// True if a term is a viscosity's.
bool is_viscous(const Case& scene);

struct Mode;
class StepMap;

/// What theory says of the steps of a case's own set: the motions that it carries, under the case's integrator. On a lattice whose faces
/// are periodic or mirrors these are the wave vectors that fit into its box, the damping as asked for. Elsewhere they are the
/// eigenvalues of the assembled operator with what lies beyond its walls, viscosity at half strength: all of a small set's, of a large
/// one's those of largest magnitude and largest real part.
class StepTheory {
public:
    /// The case must outlive the theory.
    explicit StepTheory(const Case& scene, Damping damping = {.viscosity = 0.5});
    ~StepTheory();

    StepLimit limit() const;
    /// Largest ln |xi| of a step dt [s].
    double growth(double dt) const;
    /// Of the operator [1/s].
    const std::vector<std::complex<double>>& eigenvalues() const { return eigenvalues_; }
    /// Such as "the 26 wave vectors of its box".
    const std::string& basis() const { return basis_; }
    /// True where the damping is as asked for.
    bool by_box() const { return by_box_; }

private:
    const Case& scene_;
    std::vector<Mode> modes_;
    std::unique_ptr<StepMap> map_;    ///< where walls remember
    std::vector<std::complex<double>> eigenvalues_;
    std::string basis_;
    bool by_box_ = false;

    void of_assembled(double dissipation);
};

/// What grows in a set whatever the step, by theory.
struct SetGrowth {
    double rate = 0;                          ///< ln of the worst motion's amplitude per second; 0 where nothing is known to grow
    std::optional<double> dt_limit{};         ///< where walls that remember bear less than the set does [s]
    std::string basis{};                      ///< such as "200 eigenvalues of the assembled operator of a box of 10 x 10 dx"
    std::string place{}, cause{}, remedy{};   ///< JSON pointer and words, where it grows
};

/// That of a case at a step dt [s] that its particles bear, by a small set of the same make: its spacing, disorder, forms, media and
/// walls in a box of few particles a side, at an interface if there is one. Rates of walls that remember go as one over the distance
/// between faces, and are taken to the case's own. Lattices between mirrors, and sets whose forms are adjoint, keep their energy.
SetGrowth set_growth(const Case& scene, double dt);

/// Largest |xi| of a step in which the operator times the step has the eigenvalue `z`, alike for p and u.
double amplification(const Case& scene, std::complex<double> z);

/// True if the case's integrator passes through states within a step that it does not keep: walls with memory cannot follow it.
bool works_in_stages(const Case& scene);
/// How many rates the integrator evaluates in a step, each of which reads one support further.
int evaluations_per_step(const Case& scene, long index);

/// How the case's lattice and integrator carry a steady tone at step dt, mean over axis and diagonals; nothing where no wave
/// of that frequency travels. Without viscosity.
std::optional<abi::ToneResponse> tone_response(const Case& scene, double omega, double dt, int medium = 0);

}    // namespace sphonic
