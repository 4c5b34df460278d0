#include "form_fit.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include <sphonic/error.hpp>
#include <sphonic/stability.hpp>

namespace sphonic {
namespace {

constexpr double usual_courant[4] = {0, 0.9, 0.7, 0.5}, usual_on_clouds[4] = {0, 0.6, 0.5, 0.4};
constexpr double margin = 0.98;    ///< of the integrator's limit that the operator may use

void for_fitted(Case& scene, auto visit) {
    for (Variable& v : scene.equations.variables)
        for (std::size_t t = 0; t < v.terms.size(); ++t)
            if (v.terms[t].form && v.terms[t].form->reach() > 0)
                visit(v.terms[t], scene.file + ": /equations/" + v.name + "/" + std::to_string(t) + "/form");
}

/// Weights of their own are those of a full neighbourhood at rest.
void check(const Case& scene, const abi::Form& form, const std::string& place) {
    if (scene.motion != Motion::frozen || scene.neighbours == Neighbours::moving)
        throw Error(Fault::input, place, "this form's weights are computed once, for a set that does not move", "Use a frozen set, or another form");
    if (!scene.on_lattice() && form.cloud_reach(scene.box.dimension) == 0)
        throw Error(Fault::input, place, "this form's weights are made for a lattice", "Use a frozen lattice, or another form");
    if (!scene.obstacles.empty())
        throw Error(Fault::input, place, "this form's weights are made for waves without obstacles", "Use another form, such as \"corrected\"");
    if (!scene.on_lattice() && scene.media->several())
        throw Error(Fault::input, place, "this form's weights on a set without structure hold in one medium, and here are " +
                    std::to_string(scene.media->list().size()), "Use a frozen lattice, or another form");
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true})
            if (scene.closure(a, upper) == abi::Closure::free)
                throw Error(Fault::input, place, "this form's weights need neighbours on all sides, and the face " + std::string(1, "xyz"[a]) +
                            (upper ? "_max" : "_min") + " is free", "Close the box: periodic, rigid, soft, absorbing_mur");
}

/// One of each pair o, -o within `reach` spacings.
LatticeWeights half_ball(int dimension, double reach) {
    LatticeWeights all;
    const int n = int(std::floor(reach + 1e-9)), ny = dimension > 1 ? n : 0, nz = dimension > 2 ? n : 0;
    for (int k = -nz; k <= nz; ++k)
        for (int j = -ny; j <= ny; ++j)
            for (int i = -n; i <= n; ++i) {
                const int leading = k ? k : j ? j : i;
                if (leading > 0 && i * i + j * j + k * k <= reach * reach + 1e-9) all.offset.push_back({i, j, k});
            }
    all.weight.resize(all.offset.size());
    return all;
}

/// What the leapfrog's error in time depends on, or 0 for other integrators.
double cancelled(const Case& scene, double courant) { return scene.integrator->stagger() != abi::Stagger::none ? courant : 0; }

/// For a medium in which c0 dt/dx is `courant`.
std::shared_ptr<const LatticeWeights> fitted(const Case& scene, const abi::Form& form, double courant) {
    auto weights = std::make_shared<LatticeWeights>(half_ball(scene.box.dimension, form.reach()));
    std::vector<int> by_axis[3];
    for (const auto& o : weights->offset)
        for (std::size_t a = 0; a < 3; ++a) by_axis[a].push_back(o[a]);
    const double bears = oscillator_limit(scene);
    form.fit({.dimension = scene.box.dimension, .n = int(weights->weight.size()),
              .offset = {by_axis[0].data(), by_axis[1].data(), by_axis[2].data()}, .courant = cancelled(scene, courant),
              .most = bears > 0 ? margin * bears / courant : std::numeric_limits<double>::infinity()},
             weights->weight.data());
    return weights;
}

}    // namespace

bool fits_cloud(const Case& scene) {
    if (scene.on_lattice()) return false;
    for (const Variable& v : scene.equations.variables)
        for (const Term& term : v.terms)
            if (!term.fitted.empty()) return true;
    return false;
}

void fit_forms(Case& scene) {
    bool any = false;
    for_fitted(scene, [&](Term& term, const std::string& place) {
        check(scene, *term.form, place);
        any = true;
    });
    if (!any) return;
    StepChoice& step = scene.step;
    if (!step.dt && !step.courant) {
        step.courant = (scene.on_lattice() ? usual_courant : usual_on_clouds)[scene.box.dimension];
        step.courant_length = scene.box.dx;
    }
    const double dt = scene.whole_step(step.dt ? *step.dt : *step.courant * step.courant_length / scene.media->fastest().c0);
    std::map<std::string, std::vector<std::shared_ptr<const LatticeWeights>>> known;
    for_fitted(scene, [&](Term& term, const std::string& place) {
        try {
            auto& weights = known[term.form_text];
            if (weights.empty())
                for (const abi::Medium& m : scene.media->list()) weights.push_back(fitted(scene, *term.form, m.c0 * dt / scene.box.dx));
            term.fitted = weights;
            term.cancelled = cancelled(scene, scene.medium.c0 * dt / scene.box.dx);
        } catch (const std::invalid_argument& e) {
            throw Error(Fault::input, place, e.what());
        }
    });
}

}    // namespace sphonic
