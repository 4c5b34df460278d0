#include "single_system.hpp"

#include <cmath>

#include <sphonic/error.hpp>

#include "lanes.hpp"
#include "parallel.hpp"

namespace sphonic {
namespace {

[[noreturn]] void refuse(const Case& scene, const std::string& why) {
    throw Error(Fault::input, scene.file + ": /precision", "single precision is of linear lattices, and " + why, "Choose \"double\"");
}

void require_linear_lattice(const Case& scene) {
    if (!scene.on_lattice()) refuse(scene, "these neighbours are not found by their place on a lattice");
    if (scene.equations.density >= 0) refuse(scene, "differences from a density at rest would drown in its last digits");
    for (const Variable& v : scene.equations.variables) {
        if (!v.evolved()) refuse(scene, v.name + " is computed from another variable");
        for (const Term& term : v.terms) {
            if (term.viscosity) refuse(scene, "viscosity works in double precision");
            if (!term.factors.empty()) refuse(scene, "a term of " + v.name + " is a product of variables");
        }
    }
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true})
            if (const abi::Boundary* face = scene.face(a, upper); face && face->admittance() > 0) refuse(scene, "walls of an impedance work in double precision");
}

/// Calls with every value of a field.
template <class Block>
void in_field(const LatticeGrid& grid, Block block) { in_blocks(grid.threads, grid.layout.size, block); }

}    // namespace

SingleSystem::SingleSystem(const Case& scene) : SingleSystem((require_linear_lattice(scene), scene), Sites(scene)) {}

SingleSystem::SingleSystem(const Case& scene, const Sites& sites)
    : scene_(scene), components_(scene), media_(place_particles(scene, sites, x_)), grid_(scene, media_, lanes_of<float>),
      ghosts_(scene, components_, media_, grid_.layout, grid_.tiles, grid_.threads), store_(grid_.layout.size, components_.count),
      pressure_(scene.equations.find("p")), velocity_(scene.equations.find("u")), budget_(scene.box, scene.media->fastest()) {
    const double* x[3] = {x_[0].data(), x_[1].data(), x_[2].data()};
    for (int c = 0; c < components_.count; ++c) state_.push_back(store_.array(abi::state, c));
    out_.resize(std::size_t(components_.count));
    for (GroupParts& parts : GroupParts::all(scene, components_)) parts_.push_back(make_part(std::move(parts)));
    for (const SourceUse& use : scene.sources) sources_.emplace_back(use, scene, media_, layout(), x);
    layers_ = damped_particles(scene, media_, layout(), x);
}

SingleSystem::Part SingleSystem::make_part(GroupParts parts) const {
    Part part{std::move(parts), nullptr};
    part.terms = std::make_unique<LatticeTerms<float>>(grid_, components_, part.variables);
    return part;
}

std::array<const double*, 3> SingleSystem::positions() const { return {x_[0].data(), x_[1].data(), x_[2].data()}; }

double SingleSystem::value(const char* variable, long particle) {
    const long n = layout().count[0];
    return field(first(scene_.equations.find(variable)))[layout().row(particle / n) + particle % n];
}

double SingleSystem::bytes() const { return store_.bytes() + 8.0 * double(particles()) * scene_.box.dimension; }

void SingleSystem::evaluate(Part& part, double t, abi::Slot out, double scale, bool assign) {
    for (const int c : part.components) out_[std::size_t(c)] = store_.array(out, c);
    part.terms->evaluate({state_.data(), out_.data(), scale, assign});
    add_sources(part, t, out, scale);
}

void SingleSystem::rate(abi::Group group, double t, abi::Slot out) { evaluate(part(group), t, out, 1, true); }

void SingleSystem::rate_of(int variable, double t, abi::Slot out) {
    Part single = make_part({scene_, components_, {variable}, false});
    evaluate(single, t, out, 1, true);
}

void SingleSystem::advance(abi::Group group, double t, double dt) {
    Part& p = part(group);
    if (!p.reads_itself) return evaluate(p, t, abi::state, dt, false);
    const abi::Slot scratch = store_.history("core: rate");
    evaluate(p, t, scratch, 1, true);
    axpy(group, dt, scratch, abi::state);
}

void SingleSystem::copy(abi::Group group, abi::Slot from, abi::Slot to) {
    for (const int c : part(group).components) {
        const float* source = store_.array(from, c);
        float* target = store_.array(to, c);
        in_field(grid_, [=](long begin, long end) { std::copy(source + begin, source + end, target + begin); });
    }
}

void SingleSystem::axpy(abi::Group group, double a, abi::Slot x, abi::Slot y) {
    const float factor = float(a);
    for (const int c : part(group).components) {
        const float* added = store_.array(x, c);
        float* target = store_.array(y, c);
        in_field(grid_, [=](long begin, long end) {
            const float* __restrict from = added;
            float* __restrict to = target;
            for (long i = begin; i < end; ++i) to[i] += factor * from[i];
        });
    }
}

void SingleSystem::settle(abi::Group group, double t) {
    const Part& changed = part(group);
    for (SourceMembers& source : sources_)
        impose(source, t, source.action.sets_pressure && changed.has(pressure_), source.action.sets_velocity && changed.has(velocity_));
    for (const int c : changed.components) ghosts_.fill(c, store_.array(abi::state, c), field(first(pressure_)), t);
}

void SingleSystem::impose(SourceMembers& source, double t, bool pressure, bool velocity) {
    if (!pressure && !velocity) return;
    source.evaluate(t, pressure, velocity, grid_.threads);
    const auto put = [&](const std::vector<double>& value, int component, auto inertia) {
        float* target = store_.array(abi::state, component);
        for (std::size_t i = 0; i < value.size(); ++i) {
            target[source.at()[i]] = float(value[i]);
            budget_.imposed(value[i], inertia(medium(source, i)));
        }
    };
    if (pressure) put(source.p(), first(pressure_), [](const abi::Medium& m) { return 1 / bulk_modulus(m); });
    for (int a = 0; velocity && a < scene_.box.dimension; ++a) put(source.u(a), first(velocity_) + a, [](const abi::Medium& m) { return m.rho0; });
}

void SingleSystem::add_sources(const Part& part, double t, abi::Slot out, double scale) {
    const bool pressure = part.has(pressure_), velocity = part.has(velocity_);
    double energy = 0;
    for (SourceMembers& source : sources_) {
        if (!source.action.adds || !(pressure || velocity)) continue;
        source.evaluate(t, pressure, velocity, grid_.threads);
        const auto add = [&](const std::vector<double>& rate, int component, auto inertia) {
            float* target = store_.array(out, component);
            for (std::size_t i = 0; i < rate.size(); ++i) {
                target[source.at()[i]] += float(scale * rate[i]);
                energy += inertia(medium(source, i)) * rate[i] * rate[i];
            }
        };
        if (pressure) add(source.p(), first(pressure_), [](const abi::Medium& m) { return 1 / bulk_modulus(m); });
        for (int a = 0; velocity && a < scene_.box.dimension; ++a) add(source.u(a), first(velocity_) + a, [](const abi::Medium& m) { return m.rho0; });
    }
    supply_ = std::max(supply_, 0.5 * scene_.particle_volume() * energy);
}

void SingleSystem::initialise(double dt) {
    ghosts_.restart();
    for (Damped& d : layers_) d.factor = std::exp(-d.rate * dt);
    std::vector<double> value(static_cast<std::size_t>(particles()));
    const auto x = positions();
    const abi::Points points{scene_.box.dimension, int(value.size()), {x[0], x[1], x[2]}};
    for (const InitialField& given : scene_.initial) {
        const int v = scene_.equations.find(given.variable);
        for (int c = 0; c < scene_.equations.variables[std::size_t(v)].components(scene_.box.dimension); ++c) {
            scene_.initial_values(given.variable, c, points, value.data());
            scatter(layout(), value.data(), store_.array(abi::state, first(v) + c));
        }
    }
    for (SourceMembers& source : sources_) impose(source, 0, false, source.action.sets_velocity_at_start);
    settle(abi::everything, 0);
}

void SingleSystem::forget_walls() {
    ghosts_.restart();
    settle(abi::everything, 0);
}

void SingleSystem::close_step(double, double dt) {
    for (int c = 0; c < components_.count; ++c) {
        float* field = store_.array(abi::state, c);
        for (const Damped& d : layers_) field[d.at] *= float(d.factor);
    }
    budget_.added(supply_, dt);
    supply_ = 0;
}

}    // namespace sphonic
