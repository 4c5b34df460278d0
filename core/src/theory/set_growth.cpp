#include <algorithm>
#include <cmath>
#include <random>

#include <sphonic/error.hpp>
#include <sphonic/shown.hpp>
#include <sphonic/stability.hpp>

#include "form_fit.hpp"
#include "modes.hpp"
#include "particle_system.hpp"
#include "small_set.hpp"

namespace sphonic {
namespace {

constexpr double clearly[4] = {0, 1e-4, 1e-3, 1e-3};    ///< of ln |xi| of whole steps: what is less may be a drift
constexpr int halvings = 6;                             ///< in search of the step that walls bear

/// Whether dE/dt = 0 for E = 1/2 sum (p^2 + u^2) in units of one medium: A is antisymmetric, and nothing grows.
bool keeps_energy(const Case& scene) {
    if (scene.media->several()) return false;
    ParticleSystem system(scene);
    const std::size_t n = std::size_t(system.values());
    std::mt19937_64 bits(1);
    std::vector<double> x(n), y(n), Ax(n), Ay(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = double(bits() >> 11) * 0x1p-52 - 1, y[i] = double(bits() >> 11) * 0x1p-52 - 1;
    system.linear_rate(x.data(), Ax.data(), 1);
    system.linear_rate(y.data(), Ay.data(), 1);
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < n; ++i) sum += y[i] * Ax[i] + x[i] * Ay[i], size += y[i] * y[i] + Ax[i] * Ax[i];
    return std::abs(sum) < 1e-7 * size;
}

bool remembers(const abi::Boundary* face) { return face && (face->closure() == abi::Closure::layers || face->admittance() > 0); }

/// What of a case makes its set grow, with the place of it and the remedy.
void name_cause(const Case& scene, const Case& small, bool ends_alone, SetGrowth& growth) {
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true})
            if (remembers(scene.face(a, upper))) {
                growth.place = "/boundaries/" + std::to_string(scene.boundary_of[a][upper]);
                growth.cause = std::string("the wall at ") + "xyz"[a] + (upper ? "_max" : "_min") + " remembers, and feeds the shortest waves along it";
                growth.remedy = "End the run sooner, or take impedance, absorbing_layer or soft";
                return;
            }
    growth.place = "/equations";
    const std::string forms = "the forms of divergence and gradient are not adjoint ";
    if (ends_alone) {
        growth.cause = forms + "beside a face without virtual particles";
        growth.remedy = "Give the faces rigid or soft walls, or take linear_acoustics";
    } else if (!small.regular()) {
        growth.cause = forms + "on disordered particles";
        growth.remedy = "Add fourth_order dissipation, or take band_fitted_acoustics, linear_acoustics or an adjoint pair of forms";
    } else {
        growth.cause = forms + "where the media meet at such a contrast";
        growth.remedy = "Take the form impedance, as \"acoustics\" does";
    }
}

/// The largest of a few steps below dt that walls bear; 0 where growth goes with time and not with the step.
double borne(const StepTheory& theory, double dt, double growth, double clear) {
    double low = 0.5 * dt, high = dt;
    const auto grows = [&](double step) { return theory.growth(step) > clear; };
    if (growth < 10 * clear || theory.growth(low) > std::max(clear, 0.1 * growth)) return 0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (grows(middle) ? high : low) = middle;
    }
    return low;
}

/// Least distance between the faces of an axis with a wall that remembers: what passes it comes back the sooner the smaller it is.
double passage(const Case& scene) {
    double least = INFINITY;
    for (int a = 0; a < scene.box.dimension; ++a)
        if (remembers(scene.face(a, false)) || remembers(scene.face(a, true))) least = std::min(least, scene.box.upper[a] - scene.box.lower[a]);
    return least;
}

void judge_walls(const Case& scene, const Case& small, const StepTheory& theory, double dt, SetGrowth& found) {
    const double own = std::log(amplification(small, dt)), growth = theory.growth(dt) - std::max(0.0, own);    // of a weak integrator
    const double clear = clearly[small.box.dimension];
    if (!(growth > clear)) return;
    if (const double limit = borne(theory, dt, growth, clear); limit > 0)
        found.dt_limit = limit;
    else
        found.rate = growth / dt * passage(small) / passage(scene);
}

std::string size_of(const Case& small) {
    std::string text;
    for (int a = 0; a < small.box.dimension; ++a) text += (a ? " x " : "") + shown((small.box.upper[a] - small.box.lower[a]) / small.box.dx, 3);
    return text + " dx";
}

/// Of the small set alone; what it cannot be made of, the case itself will complain about.
SetGrowth growth_of(const Case& scene, const Case& small, double dt) try {
    SetGrowth found;
    const bool walls = passage(small) < INFINITY;
    if (!walls && keeps_energy(small)) return found;
    const StepTheory theory(small);
    if (walls)
        judge_walls(scene, small, theory, dt, found);
    else
        for (const auto& value : theory.eigenvalues()) found.rate = std::max(found.rate, value.real());
    found.basis = theory.basis() + ", of a piece of " + size_of(small) + (scene.obstacles.empty() ? "" : " without obstacles");
    return found;
} catch (const Error&) {
    return {};
}

}    // namespace

SetGrowth set_growth(const Case& scene, double dt) {
    if (!scene.method->meshfree() || (carries_waves(scene) && !fits_cloud(scene))) return {};
    const std::optional<Case> small = small_set(scene, dt);
    if (!small) return {};
    SetGrowth found = growth_of(scene, *small, dt);
    if (!(found.rate > 0) && !found.dt_limit) return found;
    std::optional<Case> closed;
    if (!(passage(scene) < INFINITY)) closed = small_set(scene, dt, true);
    name_cause(scene, *small, closed && growth_of(scene, *closed, dt).rate < 0.1 * found.rate, found);
    return found;
}

}    // namespace sphonic
