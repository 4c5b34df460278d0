#include "sentinel.hpp"

#include <cmath>
#include <sstream>

namespace sphonic {
namespace {

/// The energy of p and u at one time swings about the scheme's own invariant, by up to 1 / (1 - dt/dt_limit) for the highest
/// mode: ten at the default step. Ten times that is growth.
constexpr double margin = 100;

}    // namespace

Sentinel::Sentinel(const Case& scene, abi::Solver& solver) : Sentinel(scene, solver, solver.snapshot().points) {}

Sentinel::Sentinel(const Case& scene, abi::Solver& solver, const abi::Points& points)
    : scene_(scene), solver_(solver), media_(scene, points.n, points.x) {
    keep(solver.snapshot());
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
    double sum = 0;
    for (int i = 0; i < shot.points.n; ++i) {
        const abi::Medium& m = media_.of(i);
        double density = shot.p[i] * shot.p[i] / bulk_modulus(m);
        for (int a = 0; a < shot.points.dimension && shot.u[a]; ++a) density += m.rho0 * shot.u[a][i] * shot.u[a][i];
        if (free_[std::size_t(i)]) sum += density;
    }
    return 0.5 * scene_.particle_volume() * sum;
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
    keep(shot);
    return std::nullopt;
}

void Sentinel::keep(const abi::Snapshot& shot) {
    good_.t = solver_.time();
    for (int a = 0; a < shot.points.dimension; ++a) good_.x[a].assign(shot.points.x[a], shot.points.x[a] + shot.points.n);
    good_.p.assign(shot.p, shot.p + shot.points.n);
}

}    // namespace sphonic
