#include "sentinel.hpp"

#include <cmath>
#include <sstream>

namespace sphonic {
namespace {

/// The energy of p and u at one time swings about the scheme's own invariant, by up to 1 / (1 - dt/dt_limit) for the highest
/// mode: ten at the default step. Ten times that is growth.
constexpr double margin = 100;

}    // namespace

Sentinel::Sentinel(const Case& scene, abi::Solver& solver) : scene_(scene), solver_(solver) {
    const abi::Points points = solver.snapshot().points;
    free_.assign(std::size_t(points.n), 1);
    std::vector<unsigned char> inside(free_.size());
    for (const SourceUse& use : scene.sources) {
        if (!use.source->action().sets()) continue;
        use.inside(points, inside.data());
        for (std::size_t i = 0; i < inside.size(); ++i)
            if (inside[i]) free_[i] = 0;
    }
}

/// 1/2 sum V (p^2/K + rho0 u^2): never negative, unlike the invariant of a staggered scheme beyond its limit.
double Sentinel::energy(const abi::Snapshot& shot) const {
    const auto& m = scene_.medium;
    double potential = 0, kinetic = 0;
    for (int i = 0; i < shot.points.n; ++i) potential += free_[std::size_t(i)] * shot.p[i] * shot.p[i];
    for (int a = 0; a < shot.points.dimension && shot.u[a]; ++a)
        for (int i = 0; i < shot.points.n; ++i) kinetic += free_[std::size_t(i)] * shot.u[a][i] * shot.u[a][i];
    return 0.5 * scene_.particle_volume() * (potential / (m.rho0 * m.c0 * m.c0) + m.rho0 * kinetic);
}

std::string Sentinel::complaint(const abi::Snapshot& shot, double energy) const {
    int worst = 0;
    const auto size = [&](int i) { return std::isfinite(shot.p[i]) ? free_[std::size_t(i)] * std::abs(shot.p[i]) : INFINITY; };
    for (int i = 0; i < shot.points.n; ++i)
        if (size(i) > size(worst)) worst = i;
    std::ostringstream text;
    text.precision(4);
    text << "at t = " << solver_.time() << " s the pressure of particle " << worst << " at (";
    for (int a = 0; a < shot.points.dimension; ++a) text << (a ? ", " : "") << shot.points.x[a][worst];
    text << ") m is " << shot.p[worst] << " Pa, and the energy of the set is " << energy << ", where its start and its sources account for "
         << solver_.energy_bound() << "; all was well at t = " << good_.t << " s";
    return text.str();
}

std::optional<std::string> Sentinel::look() {
    const abi::Snapshot shot = solver_.snapshot();
    const double now = energy(shot);
    if (!(now <= margin * solver_.energy_bound()) || !std::isfinite(now)) return complaint(shot, now);
    good_.t = solver_.time();
    for (int a = 0; a < shot.points.dimension; ++a) good_.x[a].assign(shot.points.x[a], shot.points.x[a] + shot.points.n);
    good_.p.assign(shot.p, shot.p + shot.points.n);
    return std::nullopt;
}

}    // namespace sphonic
