#include "lanes.hpp"
#include "particle_system.hpp"

/// How a set begins.
namespace sphonic {

ParticleMedia place_particles(const Case& scene, const Sites& sites, Places& x) {
    const double* begin[3] = {};
    for (int a = 0; a < scene.box.dimension; ++a) {
        x[a] = sites.own[a];
        x[a].resize(sites.own[a].size() + overrun);
        begin[a] = x[a].data();
    }
    return {scene, sites.count(), begin};
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

double ParticleSystem::value(const char* variable, long particle) {
    const Layout& l = layout();
    const long row = particle / l.count[0];
    return field(components_.first[std::size_t(scene_.equations.find(variable))])[l.row(row) + particle % l.count[0]];
}

void ParticleSystem::initialise(double dt) {
    tier_->restart();
    flow_ = WallFlow(scene_, media_, layout(), threads_, dt);
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
    const int component = components_.first[std::size_t(of_pressure_.variable)];
    flow_.begin(field(component), components_.rest(component));
}

}    // namespace sphonic
