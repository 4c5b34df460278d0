#include "particle_system.hpp"

#include <algorithm>
#include <numeric>

#include <sphonic/error.hpp>

#include "parallel.hpp"

namespace sphonic {

Components::Components(const Case& scene) {
    const int d = scene.box.dimension;
    for (const Variable& v : scene.equations.variables) {
        first.push_back(count);
        const bool density = scene.equations.density == int(first.size()) - 1;
        for (int a = 0; a < v.components(d); ++a, ++count) {
            axis_.push_back(v.is_vector ? a : -1);
            rest_.push_back(density ? scene.medium.rho0 : 0);
        }
    }
    if (scene.motion == Motion::lagrangian) {
        positions = count;
        count += d;
    }
}

abi::Part Components::part(int component, int axis) const {
    const int own = axis_[std::size_t(component)];
    return own < 0 ? abi::Part::scalar : own == axis ? abi::Part::normal : abi::Part::tangential;
}

namespace {

std::unique_ptr<Tier> choose_tier(const Case& scene, const Components& components, const ParticleMedia& media, const Sites& sites, const double* const* x) {
    if (scene.on_lattice()) return make_lattice_tier(scene, components, media);
    return make_list_tier(scene, components, media, sites, x, scene.motion == Motion::frozen && scene.neighbours != Neighbours::moving);
}

}    // namespace

ParticleSystem::ParticleSystem(const Case& scene) : ParticleSystem(scene, Sites(scene)) {}

ParticleSystem::ParticleSystem(const Case& scene, const Sites& sites)
    : scene_(scene), components_(scene),
      threads_(threads_for(scene)), media_(place_particles(scene, sites, x_)), store_(0, 0), pressure_(scene.equations.find("p")), velocity_(scene.equations.find("u")), of_pressure_(scene.behind(pressure_)), budget_(scene.box, scene.media->fastest()) {
    const double* x[3] = {x_[0].data(), x_[1].data(), x_[2].data()};
    tier_ = choose_tier(scene, components_, media_, sites, x);
    store_ = Store(layout().size, components_.count);
    for (int c = 0; c < components_.count; ++c) state_arrays_.push_back(store_.array(abi::state, c));
    out_arrays_.resize(std::size_t(components_.count));
    order_algebraic();
    make_parts();
    for (const SourceUse& use : scene.sources) sources_.emplace_back(use, scene, media_, layout(), x);
    for (const SourceMembers& source : sources_) supplied_ = supplied_ || source.action.adds;
    layers_ = damped_particles(scene, media_, layout(), x);
    if (std::any_of(scene.obstacles.begin(), scene.obstacles.end(), [](const Obstacle& o) { return o.walled(); }))
        smoothing_ = std::make_unique<WallSmoothing>(scene, sites, threads_);
}

ParticleSystem::Part ParticleSystem::make_part(GroupParts parts) {
    Part part{std::move(parts), nullptr};
    if (!part.variables.empty()) part.program = tier_->compile(part.variables);
    return part;
}

void ParticleSystem::make_parts() {
    for (GroupParts& parts : GroupParts::all(scene_, components_)) parts_.push_back(make_part(std::move(parts)));
}

ParticleSystem::Part& ParticleSystem::part(abi::Group group) { return parts_[GroupParts::number(group, groups())]; }

void ParticleSystem::evaluate_terms(Part& part, abi::Slot out, double scale, bool assign, Terms terms) {
    for (const int c : part.components) out_arrays_[std::size_t(c)] = store_.array(out, c);
    if (part.program) part.program->evaluate({state_arrays_.data(), out_arrays_.data(), scale, assign, terms});
}

void ParticleSystem::evaluate(Part& part, double t, abi::Slot out, double scale, bool assign) {
    evaluate_terms(part, out, scale, assign);
    if (supplied_ && !part.variables.empty()) add_sources(part, t, out, scale);
    if (part.positions) move(out, scale, assign);
}

template <class Block>
void ParticleSystem::in_stepped(Block block) const {
    const LatticeTiles* tiles = tier_->tiles();
    if (!tiles || tiles->all()) return in_blocks(threads_, layout().size, block);
    tiles->for_stretches(threads_, [&](const LatticeTiles::Stretch& s) { block(s.offset, s.offset + s.n); });
}

/// The rate of the positions.
void ParticleSystem::move(abi::Slot out, double scale, bool assign) {
    const int u = components_.first[std::size_t(scene_.equations.velocity)];
    for (int a = 0; a < scene_.box.dimension; ++a) {
        const double* velocity = state_arrays_[std::size_t(u + a)];
        double* target = store_.array(out, components_.positions + a);
        in_stepped([=](long begin, long end) {
            const double* __restrict from = velocity;
            double* __restrict to = target;
            for (long i = begin; i < end; ++i) to[i] = (assign ? 0 : to[i]) + scale * from[i];
        });
    }
}

void ParticleSystem::rate(abi::Group group, double t, abi::Slot out) {
    note_evaluation(part(group));
    evaluate(part(group), t, out, 1, true);
}

void ParticleSystem::rate_of(int variable, double t, abi::Slot out) {
    Part single = make_part({scene_, components_, {variable}, false});
    evaluate(single, t, out, 1, true);
}

void ParticleSystem::advance(abi::Group group, double t, double dt) {
    Part& p = part(group);
    if (!p.reads_itself) {
        note_evaluation(p);
        return evaluate(p, t, abi::state, dt, false);
    }
    const abi::Slot scratch = store_.history("core: rate");
    rate(group, t, scratch);
    axpy(group, dt, scratch, abi::state);
}

void ParticleSystem::copy(abi::Group group, abi::Slot from, abi::Slot to) {
    const Part& p = part(group);
    const auto one = [&](int c) {
        const double* source = store_.array(from, c);
        double* target = store_.array(to, c);
        in_stepped([=](long begin, long end) { std::copy(source + begin, source + end, target + begin); });
    };
    for (const int c : p.components) one(c);
    for (int a = 0; p.positions && a < scene_.box.dimension; ++a) one(components_.positions + a);
}

void ParticleSystem::axpy(abi::Group group, double a, abi::Slot x, abi::Slot y) {
    const Part& p = part(group);
    const auto one = [&](int c) {
        const double* added = store_.array(x, c);
        double* target = store_.array(y, c);
        in_stepped([=](long begin, long end) {
            const double* __restrict from = added;
            double* __restrict to = target;
            for (long i = begin; i < end; ++i) to[i] += a * from[i];
        });
    };
    for (const int c : p.components) one(c);
    for (int axis = 0; p.positions && axis < scene_.box.dimension; ++axis) one(components_.positions + axis);
}

void ParticleSystem::settle(abi::Group group, double t) {
    const Part& changed = part(group);
    if (changed.positions) {
        const double* x[3] = {};
        for (int a = 0; a < scene_.box.dimension; ++a) x[a] = field(components_.positions + a);
        tier_->moved(x);
    }
    for (SourceMembers& source : sources_)
        impose(source, t, source.action.sets_pressure && changed.has(of_pressure_.variable), source.action.sets_velocity && changed.has(velocity_));
    refresh_algebraic(changed, t);
    const double* p_field = field(components_.first[std::size_t(pressure_)]);
    for (const int c : changed.components) tier_->fill_ghosts(c, store_.array(abi::state, c), p_field, t);
}

void ParticleSystem::refresh_algebraic(const Part& changed, double t) {
    for (const int v : algebraic_) {
        const Variable& variable = scene_.equations.variables[std::size_t(v)];
        if (std::find(changed.variables.begin(), changed.variables.end(), evolved_behind(v)) == changed.variables.end()) continue;
        double* y = store_.array(abi::state, components_.first[std::size_t(v)]);
        const double* x = field(components_.first[std::size_t(variable.of)]);
        const auto evaluate = [&](long at, long n) { variable.state->evaluate(scene_.medium, int(n), x + at, y + at); };
        if (const LatticeTiles* tiles = tier_->tiles())
            tiles->for_stretches(threads_, [&](const LatticeTiles::Stretch& s) { evaluate(s.offset, s.n); });
        else
            in_row_blocks(threads_, layout(), [&](long, long at, long, long n) { evaluate(at, n); });
        tier_->fill_ghosts(components_.first[std::size_t(v)], y, field(components_.first[std::size_t(pressure_)]), t);
    }
}

/// Algebraic variables, each after the one it is computed from.
void ParticleSystem::order_algebraic() {
    const auto& variables = scene_.equations.variables;
    const auto depth = [&](int v) {
        int steps = 0;
        for (; !variables[std::size_t(v)].evolved(); v = variables[std::size_t(v)].of) ++steps;
        return steps;
    };
    for (int v = 0; v < int(variables.size()); ++v)
        if (!variables[std::size_t(v)].evolved()) algebraic_.push_back(v);
    std::stable_sort(algebraic_.begin(), algebraic_.end(), [&](int a, int b) { return depth(a) < depth(b); });
}

std::array<const double*, 3> ParticleSystem::positions() {
    std::array<const double*, 3> x{};
    for (int a = 0; a < scene_.box.dimension; ++a)
        x[std::size_t(a)] = moving() ? field(components_.positions + a) : x_[a].data();
    return x;
}

double ParticleSystem::bytes() const {
    double total = store_.bytes() + tier_->bytes();
    for (const auto& x : x_) total += 8.0 * double(x.size());
    return total;
}

}    // namespace sphonic
