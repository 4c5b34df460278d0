#include <cmath>

#include "mirror_particles.hpp"
#include "parallel.hpp"
#include "particle_layers.hpp"
#include "particle_system.hpp"

/// What happens to fields once per step: layers along faces that damp them, and smoothing at the walls of obstacles,
/// what flows into walls.
namespace sphonic {

std::vector<Damped> damped_particles(const Case& scene, const ParticleMedia& media, const Layout& layout, const double* const* x) {
    const auto index = field_indices(layout);
    std::vector<Damped> layers;
    for (std::size_t i = 0; i < index.size(); ++i) {
        double rate = 0;
        for (int a = 0; a < scene.box.dimension; ++a)
            for (const bool upper : {false, true}) {
                const double distance = std::abs(end_of_set(scene, a, upper) - x[a][i]);
                if (const abi::Boundary* face = scene.face(a, upper)) rate += face->damping(distance, media.of(long(i)));
            }
        if (rate > 0) layers.push_back({index[i], rate});
    }
    return layers;
}

/// By the exact decay over a step, on all variables about their rest: once per step, whatever the integrator does within it.
void ParticleSystem::damp(double dt) {
    if (layers_.empty()) return;
    if (damping_step_ != dt)
        for (Damped& d : layers_) d.factor = std::exp(-d.rate * dt);
    damping_step_ = dt;
    const int fields = moving() ? components_.positions : components_.count;
    for (int c = 0; c < fields; ++c) {
        double* field = store_.array(abi::state, c);
        const double rest = components_.rest(c);
        const auto share = [&](long begin, long end) {
            for (long i = begin; i < end; ++i) {
                double& value = field[layers_[std::size_t(i)].at];
                value = rest + layers_[std::size_t(i)].factor * (value - rest);
            }
        };
        const long n = long(layers_.size());
        if (const LatticeTiles* tiles = tier_->tiles())
            tiles->for_entries(threads_, n, [this](long i) { return layers_[std::size_t(i)].at; }, share);
        else
            in_blocks(threads_, n, share);
    }
}

/// What p is computed from, and then p.
void ParticleSystem::treat_pressure(double t, double dt) {
    const int component = components_.first[std::size_t(of_pressure_.variable)];
    double* field = store_.array(abi::state, component);
    if (smoothing_) smoothing_->apply(field, dt);
    flow_.apply(field, components_.rest(component));
    refresh_algebraic(part(abi::fields), t);
    tier_->fill_ghosts(component, field, this->field(components_.first[std::size_t(pressure_)]), t);
}

}    // namespace sphonic
