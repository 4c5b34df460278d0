#include "parallel.hpp"
#include "particle_system.hpp"

/// What sources do to a set: values that they impose, rates that they add, and the energy that comes of it.
namespace sphonic {

void ParticleSystem::impose(SourceMembers& source, double t, bool pressure, bool velocity) {
    if (!pressure && !velocity) return;
    if (moving()) source.follow(positions().data(), threads_);
    source.evaluate(t, pressure, velocity, threads_);
    if (pressure) {
        for (std::size_t i = 0; i < source.p().size(); ++i) budget_.imposed(source.p()[i], 1 / bulk_modulus(medium(source, i)));
        set_scalar(pressure_, source.at(), source.p());
    }
    for (int a = 0; velocity && a < scene_.box.dimension; ++a) {
        for (std::size_t i = 0; i < source.u(a).size(); ++i) budget_.imposed(source.u(a)[i], medium(source, i).rho0);
        put(source.at(), source.u(a), components_.first[std::size_t(velocity_)] + a);
    }
}

void ParticleSystem::put(const std::vector<std::ptrdiff_t>& at, const std::vector<double>& value, int component) {
    double* target = store_.array(abi::state, component);
    for (std::size_t i = 0; i < at.size(); ++i) target[at[i]] = value[i];
}

/// Sets a scalar, or, where it is algebraic, the evolved variable that it is computed from.
void ParticleSystem::set_scalar(int v, const std::vector<std::ptrdiff_t>& at, std::vector<double>& value) {
    const auto& variables = scene_.equations.variables;
    for (; !variables[std::size_t(v)].evolved(); v = variables[std::size_t(v)].of)
        variables[std::size_t(v)].state->invert(scene_.medium, int(value.size()), value.data(), value.data());
    put(at, value, components_.first[std::size_t(v)]);
}

void ParticleSystem::add_sources(const Part& part, double t, abi::Slot out, double scale) {
    const auto [evolved, slope] = of_pressure_;
    const bool pressure = part.has(evolved), velocity = part.has(velocity_);
    if (!pressure && !velocity) return;
    double energy = 0;
    const auto add = [&](const SourceMembers& source, int component, const std::vector<double>& rate, double factor, auto inertia) {
        double* target = store_.array(out, component);
        for (std::size_t i = 0; i < rate.size(); ++i) {
            target[source.at()[i]] += scale * factor * rate[i];
            energy += inertia(medium(source, i)) * rate[i] * rate[i];
        }
    };
    const auto compliance = [](const abi::Medium& m) { return 1 / bulk_modulus(m); };
    const auto density = [](const abi::Medium& m) { return m.rho0; };
    for (SourceMembers& source : sources_) {
        if (!source.action.adds) continue;
        if (moving()) source.follow(positions().data(), threads_);
        source.evaluate(t, pressure, velocity, threads_);
        if (pressure) add(source, components_.first[std::size_t(evolved)], source.p(), 1 / slope, compliance);
        for (int a = 0; velocity && a < scene_.box.dimension; ++a)
            add(source, components_.first[std::size_t(velocity_)] + a, source.u(a), 1, density);
    }
    supply_ = std::max(supply_, 0.5 * scene_.particle_volume() * energy);
}

void ParticleSystem::close_step(double t, double dt) {
    damp(dt);
    if (smoothing_ || flow_.any()) treat_pressure(t, dt);
    budget_.added(supply_, dt);
    supply_ = 0;
    watch_step();
}

}    // namespace sphonic
