#include <algorithm>
#include <cmath>
#include <random>

#include <sphonic/error.hpp>

#include "lanes.hpp"
#include "mirror_particles.hpp"
#include "particle_system.hpp"

/// How a set begins: places and initial fields.
namespace sphonic {

ParticleMedia ParticleSystem::place_particles() {
    double* x[3] = {};
    for (int a = 0; a < scene_.box.dimension; ++a) {
        x_[a].resize(std::size_t(scene_.arrangement->size(scene_.box) + overrun));
        x[a] = x_[a].data();
    }
    scene_.arrangement->place(scene_.box, x);
    if (scene_.jitter > 0) displace(x);
    return {scene_, scene_.arrangement->size(scene_.box), x};
}

/// Uniform random displacements. Bounded axes keep their particles inside, and those on a face on it.
void ParticleSystem::displace(double* const* x) const {
    std::mt19937_64 bits(std::uint64_t(scene_.seed));
    const abi::Box& box = scene_.box;
    for (long i = 0; i < scene_.arrangement->size(box); ++i)
        for (int a = 0; a < box.dimension; ++a) {
            const double random = double(bits() >> 11) * 0x1p-53;    // the library's distributions differ between compilers
            if (!box.periodic[a] && (on_end(scene_, a, false, x[a][i]) || on_end(scene_, a, true, x[a][i]))) continue;
            x[a][i] += scene_.jitter * box.dx * (2 * random - 1);
            if (!box.periodic[a]) x[a][i] = std::clamp(x[a][i], end_of_set(scene_, a, false), end_of_set(scene_, a, true));
        }
}

void ParticleSystem::set_initial_fields() {
    const auto at = field_indices(layout());
    std::vector<double> value(at.size());
    const abi::Points points{scene_.box.dimension, int(at.size()), {x_[0].data(), x_[1].data(), x_[2].data()}};
    for (const InitialField& field : scene_.initial) {
        const int v = scene_.equations.find(field.variable);
        const int components = scene_.equations.variables[std::size_t(v)].components(scene_.box.dimension);
        for (int c = 0; c < components; ++c) {
            scene_.initial_values(field.variable, c, points, value.data());
            if (components == 1)
                set_scalar(v, at, value);
            else
                scatter(layout(), value.data(), store_.array(abi::state, components_.first[std::size_t(v)] + c));
        }
    }
}

void ParticleSystem::initialise() {
    tier_->restart();
    if (moving())
        for (int a = 0; a < scene_.box.dimension; ++a)
            scatter(layout(), x_[a].data(), store_.array(abi::state, components_.positions + a));
    set_initial_fields();
    for (SourceMembers& source : sources_) impose(source, 0, false, source.action.sets_velocity_at_start);
    settle(abi::everything, 0);
}

void ParticleSystem::forget_walls() {
    tier_->restart();
    settle(abi::everything, 0);
}

}    // namespace sphonic
