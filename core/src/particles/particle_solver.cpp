#include "particle_solver.hpp"

#include <cmath>

#include "form_fit.hpp"
#include "mirror_particles.hpp"
#include "particle_system.hpp"
#include "single_system.hpp"
#include "stencil.hpp"
#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/stability.hpp>

namespace sphonic {
namespace {

/// By the lattice's symbol alone?
bool symbol_knows(const Case& scene) { return scene.regular() && !scene.media->several() && !fits_cloud(scene); }

/// On a lattice of one medium by its symbol. Elsewhere the lattice's limit in units of the largest frequency, which then is
/// the assembled operator's. Fitted weights of a cloud damp besides: the leapfrog bears omega dt + sigma dt <= 2 with a
/// damping sigma, others at least as much of their limit.
StepLimit limit_of(const Case& scene, ParticleSystem& system) {
    StepLimit limit = step_limit(scene);
    if (symbol_knows(scene)) return limit;
    constexpr double margin = 0.98;    // the largest frequency is approached from below
    const double frequency = system.largest_frequency();
    if (limit.frequency > 0) limit.dt *= margin * limit.frequency / (frequency + system.damping());
    limit.frequency = frequency;
    if (scene.equations.dissipate()) limit.dt = std::min(limit.dt, margin * decaying_limit(scene) / frequency);
    return limit;
}

/// Found in double precision.
StepLimit limit_of(const Case& scene, const SingleSystem&) {
    if (symbol_knows(scene)) return step_limit(scene);
    ParticleSystem twin(scene);
    return limit_of(scene, twin);
}

/// What advances a system, ParticleSystem or SingleSystem, and measures it.
template <class System>
class ParticleSolver final : public abi::Solver {
public:
    explicit ParticleSolver(const Case& scene) : scene_(scene), system_(scene), limit_(limit_of(scene, system_)) { check_memory(); }

    double dt_limit() const override { return limit_.dt; }
    bool weakly_unstable() const override { return limit_.weak; }
    void start(double dt) override {
        dt_ = dt;
        match_tones();
        system_.initialise(dt);
        scene_.integrator->begin(system_, dt);
        system_.forget_walls();
        system_.start_budget(energy(abi::Stagger::none));    // beyond its limit a staggered scheme's own may be negative
        if (scene_.active == Active::automatic) let_sleep();
    }
    void step() override {
        scene_.integrator->step(system_, {index_, time(), dt_});
        ++index_;
        system_.close_step(time(), dt_);
    }
    double energy_bound() const override { return system_.budget().bound(time()); }
    double time() const override { return double(index_) * dt_; }
    const char* tier() const override { return system_.tier_name(); }
    double neighbours_mean() const override { return system_.neighbours_mean(); }
    double memory_bytes() const override { return system_.bytes(); }

    double pressure(long point) override { return system_.value("p", point); }
    abi::Activity activity() const override {
        abi::Activity activity = system_.activity();
        if (all_because_[0]) activity.all_because = all_because_;
        return activity;
    }

    abi::Snapshot snapshot() override {
        const long n = system_.particles();
        abi::Snapshot shot;
        shot.points = {.dimension = scene_.box.dimension, .n = int(n)};
        const auto x = system_.positions();
        for (int a = 0; a < scene_.box.dimension; ++a) {
            shot.points.x[a] = x[std::size_t(a)];
            shot.u[a] = packed("u", a, u_[a]);
        }
        shot.p = packed("p", 0, p_);
        return shot;
    }

    /// 1/2 sum V [p^2/K + rho0 u.u'], where u' is u of the neighbouring half step that the scheme's invariant asks for.
    double energy() override {
        const int u = scene_.equations.find("u");
        abi::Stagger stagger = scene_.integrator->stagger();
        if (stagger == abi::Stagger::behind_after_start) stagger = index_ == 0 ? abi::Stagger::centred : abi::Stagger::behind;
        if (u < 0 || !scene_.equations.variables[std::size_t(u)].evolved()) stagger = abi::Stagger::none;
        return energy(stagger);
    }

private:
    /// Errors grow as the scheme's states do: those of the staggered energy by up to (1 + s)/(1 - s) of it, s = dt/dt_limit, and
    /// no faster than one by one at the limit; those of an integrator without one as its worst mode.
    void let_sleep() {
        const double steps = std::max(1.0, std::round(scene_.until / dt_)), s = dt_ / limit_.dt;
        if (!(s <= 1 + 1e-9)) {
            all_because_ = "the step is beyond the stable limit";
            return;
        }
        const double exponent = limit_.weak ? steps * std::log(amplification(scene_, dt_)) : 0;
        constexpr double most = 20;
        if (exponent > most) {
            all_because_ = "the integrator's worst mode grows by more than e^20";
            return;
        }
        const double growth = limit_.weak ? std::exp(exponent) : std::min(std::sqrt((1 + s) / std::max(1 - s, 1e-300)), 1 + steps);
        constexpr double usual = 2.83;    // largest omega dt of any integrator
        system_.let_sleep({dt_, long(steps), limit_.frequency > 0 ? limit_.frequency : usual / dt_, growth});
    }

    double energy(abi::Stagger stagger) {
        const abi::Snapshot shot = snapshot();
        const int u = scene_.equations.find("u");
        const abi::Slot rates = stagger == abi::Stagger::none ? abi::state : system_.history("core: rate for the energy");
        if (rates != abi::state) system_.rate_of(u, time(), rates);
        double sum = 0;
        if (weight_.empty()) weight_ = wall_weights(shot.points);
        for (long i = 0; shot.p && i < shot.points.n; ++i) sum += weight_[std::size_t(i)] * shot.p[i] * shot.p[i] / bulk_modulus(system_.media().of(i));
        for (int a = 0; a < scene_.box.dimension; ++a)
            if (shot.u[a]) sum += kinetic(shot, a, stagger, rates);
        return 0.5 * scene_.particle_volume() * sum;
    }

    const Case& scene_;
    System system_;
    StepLimit limit_;
    double dt_ = 0;
    const char* all_because_ = "";    ///< why no particle may stand still
    long index_ = 0;
    std::vector<double> p_, u_[3], rate_;
    std::vector<double> weight_;    ///< of each particle in the energy

    /// One half for each wall that runs through a particle: half of its volume is behind it.
    std::vector<double> wall_weights(const abi::Points& points) const {
        std::vector<double> weight(std::size_t(points.n), 1.0);
        for (int a = 0; a < points.dimension; ++a)
            for (const bool upper : {false, true}) {
                const abi::Closure closure = scene_.closure(a, upper);
                if (closure == abi::Closure::free || closure == abi::Closure::periodic || scene_.face(a, upper)->half_way()) continue;
                for (int i = 0; i < points.n; ++i)
                    if (on_end(scene_, a, upper, points.x[a][i])) weight[std::size_t(i)] *= 0.5;
            }
        return weight;
    }

    /// Layers that advance by what they were, and walls with what flows into them, need states that stay.
    void check_memory() const {
        const auto remembers = [this](int a, bool upper) {
            const abi::Boundary* face = scene_.face(a, upper);
            return face && (face->closure() == abi::Closure::layers || face->admittance() > 0);
        };
        for (int a = 0; a < scene_.box.dimension; ++a)
            for (const bool upper : {false, true})
                if (remembers(a, upper) && works_in_stages(scene_))
                    throw Error(Fault::input, scene_.file + ": /integrator/type", "\"" + scene_.integrator_name + "\" works in stages, and the boundary of " +
                                std::string(1, "xyz"[a]) + (upper ? "_max" : "_min") + " acts once per step",
                                "Use leapfrog, or another boundary such as absorbing_layer");
    }

    /// Tells sources of one tone how the set carries it; disordered sets do so about as their lattice does.
    void match_tones() {
        for (std::size_t s = 0; s < scene_.sources.size(); ++s) {
            const SourceUse& use = scene_.sources[s];
            const double omega = use.source->tone();
            if (omega == 0) continue;
            const int medium = system_.medium_of_source(s);
            const auto response = tone_response(scene_, omega, dt_, medium);
            const double per_wavelength = 2 * std::acos(-1.0) * system_.media().list()[std::size_t(medium)].c0 / (omega * scene_.box.dx);
            if (!response)
                throw Error(Fault::input, use.place, "its wavelength is " + Json(per_wavelength).dump() + " particle spacings: the set carries no wave so short",
                            "Choose a smaller dx, or omega");
            try {
                use.source->match(*response);
            } catch (const std::invalid_argument& e) {
                throw Error(Fault::input, use.place, e.what());
            }
        }
    }

    const double* packed(const char* name, int axis, std::vector<double>& room) {
        const int v = scene_.equations.find(name);
        if (v < 0) return nullptr;
        room.resize(std::size_t(system_.particles()));
        gather(system_.layout(), system_.field(system_.components().first[std::size_t(v)] + axis), room.data());
        return room.data();
    }

    /// Sum of rho0 u_a u'_a: behind, u is at t - dt/2 and u' = u + dt a; centred, u u' = u^2 - (dt a / 2)^2.
    double kinetic(const abi::Snapshot& shot, int axis, abi::Stagger stagger, abi::Slot rates) {
        rate_.assign(std::size_t(shot.points.n), 0.0);
        const int component = system_.components().first[std::size_t(scene_.equations.find("u"))] + axis;
        if (rates != abi::state) gather(system_.layout(), system_.field(component, rates), rate_.data());
        const double* u = shot.u[axis];
        double sum = 0;
        for (long i = 0; i < shot.points.n; ++i) {
            const double kick = dt_ * rate_[std::size_t(i)];
            sum += weight_[std::size_t(i)] * system_.media().of(i).rho0 * (stagger == abi::Stagger::behind ? u[i] * (u[i] + kick) : u[i] * u[i] - 0.25 * kick * kick);
        }
        return sum;
    }
};

}    // namespace

std::unique_ptr<abi::Solver> make_particle_solver(const Case& scene) {
    if (scene.precision == Precision::single) return std::make_unique<ParticleSolver<SingleSystem>>(scene);
    return std::make_unique<ParticleSolver<ParticleSystem>>(scene);
}

}    // namespace sphonic
