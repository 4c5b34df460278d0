#include "sentinel.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <sphonic/shown.hpp>

#include "machine.hpp"

namespace sphonic {
namespace {

/// The energy of p and u at one time swings about the scheme's own invariant, by up to 1 / (1 - dt/dt_limit) for the highest
/// mode: ten at the default step. Ten times that is growth; some more than that is reason to look at every step.
constexpr double margin = 100, suspicious = 12;
constexpr double share = 0.01;          ///< of the time, for looks
constexpr int to_measure = 4;           ///< steps after the onset in which growth is measured
constexpr long rarest = 1000;           ///< steps between looks
constexpr long samples = 48;            ///< that a glance is at
constexpr double cheap = 0.01;     ///< of a look: what a sample of a glance may take

long pace_of(double look_s, double step_s) { return step_s > 0 ? std::clamp(long(look_s / (share * step_s)), 1L, rarest) : rarest; }

}    // namespace

Sentinel::Sentinel(const Case& scene, abi::Solver& solver, double dt) : Sentinel(scene, solver, dt, solver.snapshot()) {}

Sentinel::Sentinel(const Case& scene, abi::Solver& solver, double dt, const abi::Snapshot& shot)
    : scene_(scene), solver_(solver), dt_(dt), media_(scene, shot.points.n, shot.points.x), alarm_(suspicious) {
    const abi::Points& points = shot.points;
    keep(shot);
    free_.assign(std::size_t(points.n), 1);
    std::vector<unsigned char> inside(free_.size());
    for (const SourceUse& use : scene.sources) {
        if (!use.source->action().sets()) continue;
        use.inside(points, inside.data());
        for (std::size_t i = 0; i < inside.size(); ++i)
            if (inside[i]) free_[i] = 0;
    }
    choose_samples(points.n);
}

/// None where a solver does not have its pressure at hand.
void Sentinel::choose_samples(long n) {
    look();
    const double begin = wall_seconds();
    constexpr long tries = 10;
    for (long i = 0; i < tries; ++i) (void)solver_.pressure(i % n);
    sampled_ = (wall_seconds() - begin) / tries < cheap * look_s_ ? std::min(n, samples) : 0;
    for (int i = 0; i < 3; ++i) alarmed();    // how long it takes, and how sound that is there from the start appears
}

/// By the potential energy of some that lie evenly among all, others each time, as if they stood for all. A false alarm raises the bar.
bool Sentinel::alarmed() {
    constexpr double golden = 0.6180339887498949;
    glance_left_ = glance_between_;
    if (sampled_ == 0) return false;
    const double begin = wall_seconds();
    const long n = long(free_.size());
    double sum = 0;
    for (long k = 0; k < sampled_; ++k) {
        const long i = std::min(n - 1, long((double(k) + offset_) / double(sampled_) * double(n)));
        const double p = free_[std::size_t(i)] * solver_.pressure(i);
        sum += p * p / bulk_modulus(media_.of(i));
    }
    offset_ = std::fmod(offset_ + golden, 1.0);
    const double energy = 0.5 * scene_.particle_volume() * sum * double(n) / double(sampled_);
    glance_s_ = std::min(glance_s_, wall_seconds() - begin);
    if (energy <= alarm_ * solver_.energy_bound()) return false;
    alarm_ *= 4;
    return true;
}

/// 1/2 sum V (p^2/K + rho0 u^2): never negative, unlike the invariant of a staggered scheme beyond its limit.
double Sentinel::energy(const abi::Snapshot& shot) const {
    double sum = 0;
    for (int i = 0; i < shot.points.n; ++i) {
        const abi::Medium& m = media_.of(i);
        double density = shot.p[i] * shot.p[i] / bulk_modulus(m);
        for (int a = 0; a < shot.points.dimension && shot.u[a]; ++a) density += m.rho0 * shot.u[a][i] * shot.u[a][i];
        if (free_[std::size_t(i)]) sum += density;
    }
    return 0.5 * scene_.particle_volume() * sum;
}

/// Of the amplitude.
std::string Sentinel::growth() const {
    const double rate = 0.5 * std::log(to_.energy / from_.energy) / (to_.t - from_.t);
    if (!std::isfinite(rate)) return "all of it within a step";
    return "growing by e^" + shown(rate * dt_, 3) + " a step, " + shown(rate, 3) + " per second";
}

std::string Sentinel::place(const abi::Snapshot& shot, double energy) const {
    int worst = 0;
    const auto size = [&](int i) { return std::isfinite(shot.p[i]) ? free_[std::size_t(i)] * std::abs(shot.p[i]) : INFINITY; };
    for (int i = 0; i < shot.points.n; ++i)
        if (size(i) > size(worst)) worst = i;
    std::ostringstream text;
    text.precision(4);
    text << "at t = " << solver_.time() << " s the pressure of particle " << worst << " at (";
    for (int a = 0; a < shot.points.dimension; ++a) text << (a ? ", " : "") << (a ? shot.points.x[a][worst] : scene_.place(shot.points.x[0][worst]));
    text << ") m is " << shot.p[worst] << " Pa, and the energy of the set is " << energy << ", where its start and its sources account for "
         << solver_.energy_bound() << "; all was well at t = " << good_.t << " s";
    return text.str();
}

std::optional<std::string> Sentinel::look(bool end) {
    const double begin = wall_seconds();
    const abi::Snapshot shot = solver_.snapshot();
    const Seen now{solver_.time(), energy(shot)};
    const double bound = solver_.energy_bound();
    if (onset_.empty() && now.energy <= margin * bound && std::isfinite(now.energy)) {
        keep(shot);
        from_ = now;
        look_s_ = std::min(look_s_, wall_seconds() - begin);
        steps_left_ = now.energy > suspicious * bound ? 1 : between_;
        return std::nullopt;
    }
    if (std::isfinite(now.energy)) {
        if (steps_after_ == 1) from_ = to_;
        to_ = now;
    }
    if (onset_.empty()) onset_ = place(shot, now.energy);
    steps_left_ = 1;
    if (!end && std::isfinite(now.energy) && ++steps_after_ <= to_measure) return std::nullopt;
    return onset_ + "; " + growth();
}

void Sentinel::pace(double step_s) { between_ = pace_of(look_s_, step_s), glance_between_ = pace_of(glance_s_, step_s); }

void Sentinel::keep(const abi::Snapshot& shot) {
    good_.t = solver_.time();
    const bool still = scene_.motion == Motion::frozen && !good_.p.empty();
    for (int a = 0; a < shot.points.dimension && !still; ++a) good_.x[a].assign(shot.points.x[a], shot.points.x[a] + shot.points.n);
    good_.p.assign(shot.p, shot.p + shot.points.n);
}

}    // namespace sphonic
