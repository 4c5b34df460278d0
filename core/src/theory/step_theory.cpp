#include <algorithm>
#include <cmath>

#include "form_fit.hpp"
#include "linear_algebra.hpp"
#include "modes.hpp"
#include "particle_system.hpp"
#include "step_map.hpp"

namespace sphonic {
namespace {

using Values = std::vector<std::complex<double>>;

constexpr long most_values = 640;    ///< of a set whose eigenvalues are all found, in a second or two

/// Real parts below what the eigenvalues are known to are none: growth is claimed only where it is certain.
void settle(std::vector<RitzValue>& values, double relative) {
    double largest = 0;
    for (const RitzValue& v : values) largest = std::max(largest, std::abs(v.value));
    for (RitzValue& v : values)
        if (std::abs(v.value.real()) < relative * largest || (v.value.real() > 0 && v.residual > 0.3 * v.value.real())) v.value.real(0);
}

/// All eigenvalues of a small set, those at the edges of a large one's spectrum.
Values spectrum(const Case& scene, double dissipation) {
    ParticleSystem system(scene);
    std::vector<RitzValue> found;
    if (system.values() > most_values)
        found = ritz_values(system.values(), [&](const double* x, double* y) { system.linear_rate(x, y, dissipation); });
    else
        for (const auto& value : eigenvalues(assembled(scene, dissipation))) found.push_back({value, 0});
    settle(found, 1e-9);
    Values values;
    for (const RitzValue& v : found) values.push_back(v.value);
    return values;
}

/// True where walls remember what they were: then only whole steps are linear maps of all that there is.
bool walls_remember(const Case& scene) {
    bool remember = false;
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true}) {
            const abi::Boundary* face = scene.face(a, upper);
            remember = remember || (face && (face->closure() == abi::Closure::layers || face->admittance() > 0));
        }
    return remember;
}

}    // namespace

bool is_viscous(const Case& scene) {
    for (const Variable& v : scene.equations.variables)
        for (const Term& term : v.terms)
            if (term.viscosity) return true;
    return false;
}

StepTheory::StepTheory(const Case& scene, Damping damping) : scene_(scene) {
    by_box_ = carries_waves(scene) && !fits_cloud(scene);
    if (!by_box_) {
        of_assembled(damping.dissipation);
        return;
    }
    modes_ = box_modes(scene, damping);
    basis_ = "the " + std::to_string(modes_.size()) + " wave vectors of its box";
    for (const Mode& mode : modes_)
        for (const auto& value : sphonic::eigenvalues(mode.symbol)) eigenvalues_.push_back(value);
}

StepTheory::~StepTheory() = default;

void StepTheory::of_assembled(double dissipation) {
    eigenvalues_ = spectrum(scene_, dissipation);
    for (const auto& value : eigenvalues_)
        if (value.imag() >= 0) modes_.push_back(oscillation(scene_, value.imag(), -value.real()));
    basis_ = std::to_string(eigenvalues_.size()) + " eigenvalues of the assembled operator" + (eigenvalues_.size() < 161 ? "'s edge" : "");
    if (!walls_remember(scene_)) return;
    map_ = std::make_unique<StepMap>(scene_);
    basis_ = "the map of one whole step, with what its walls remember";
}

StepLimit StepTheory::limit() const {
    if (!map_) return step_limit(scene_, modes_);
    const double omega = largest_frequency(modes_);
    return {.dt = map_->last_stable(omega), .frequency = omega};
}

double StepTheory::growth(double dt) const { return map_ ? std::log(map_->largest_root(dt)) : std::log(worst_root(scene_, modes_, dt)); }

}    // namespace sphonic
