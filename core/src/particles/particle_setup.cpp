#include <algorithm>
#include <cmath>
#include <random>

#include <sphonic/error.hpp>

#include "lanes.hpp"
#include "particle_system.hpp"

/// How a set begins: places, members of sources, initial fields.
namespace sphonic {

void ParticleSystem::place_particles() {
    double* x[3] = {};
    for (int a = 0; a < scene_.box.dimension; ++a) {
        x_[a].resize(std::size_t(scene_.arrangement->size(scene_.box) + overrun));
        x[a] = x_[a].data();
    }
    scene_.arrangement->place(scene_.box, x);
    if (scene_.jitter > 0) displace(x);
}

/// Uniform random displacements; a particle on a face of a bounded axis stays on it.
void ParticleSystem::displace(double* const* x) const {
    std::mt19937_64 bits(std::uint64_t(scene_.seed));
    const abi::Box& box = scene_.box;
    for (long i = 0; i < scene_.arrangement->size(box); ++i)
        for (int a = 0; a < box.dimension; ++a) {
            const double random = double(bits() >> 11) * 0x1p-53;    // the library's distributions differ between compilers
            const double edge = 1e-6 * box.dx;
            const bool on_face = !box.periodic[a] && (x[a][i] < box.lower[a] + edge || x[a][i] > box.upper[a] - edge);
            if (!on_face) x[a][i] += scene_.jitter * box.dx * (2 * random - 1);
        }
}

void ParticleSystem::enlist_sources() {
    const auto index = field_indices(layout());
    for (const SourceUse& use : scene_.sources) {
        Members members{.source = use.source.get(), .at = {}, .x = {}, .p = {}, .u = {}};
        std::vector<double> point(3);
        for (std::size_t i = 0; i < index.size(); ++i) {
            for (int a = 0; a < scene_.box.dimension; ++a) point[std::size_t(a)] = x_[a][i];
            if (!use.region.contains(point.data())) continue;
            members.at.push_back(index[i]);
            for (int a = 0; a < scene_.box.dimension; ++a) members.x[a].push_back(x_[a][i]);
        }
        if (members.at.empty())
            throw Error(Fault::input, use.place, "no particle lies in \"" + use.region.text() + "\"", "Choose a region inside the box");
        members.p.resize(members.at.size());
        for (int a = 0; a < scene_.box.dimension; ++a) members.u[a].resize(members.at.size());
        members_.push_back(std::move(members));
    }
}

/// Sets a scalar, or, where it is algebraic, the evolved variable that it is computed from.
void ParticleSystem::set_scalar(int v, const std::vector<std::ptrdiff_t>& at, std::vector<double>& value) {
    const auto& variables = scene_.equations.variables;
    for (; !variables[std::size_t(v)].evolved(); v = variables[std::size_t(v)].of)
        variables[std::size_t(v)].state->invert(scene_.medium, int(value.size()), value.data(), value.data());
    double* target = store_.array(abi::state, components_.first[std::size_t(v)]);
    for (std::size_t i = 0; i < at.size(); ++i) target[at[i]] = value[i];
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
    if (moving())
        for (int a = 0; a < scene_.box.dimension; ++a)
            scatter(layout(), x_[a].data(), store_.array(abi::state, components_.positions + a));
    set_initial_fields();
    for (Members& members : members_)
        impose(members, 0, false, members.source->imposed().velocity_at_start);
    settle(abi::everything, 0);
}

}    // namespace sphonic
