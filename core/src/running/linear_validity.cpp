#include "linear_validity.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "particle_media.hpp"

namespace sphonic {
namespace {

constexpr double small = 1e-2;

struct Loudness {
    double compression = 0, mach = 0;    ///< largest |p|/(rho0 c0^2) and |u|/c0
};

Loudness loudness_of(const Case& scene, const abi::Snapshot& shot) {
    const ParticleMedia media(scene, shot.points.n, shot.points.x);
    Loudness most;
    for (int i = 0; i < shot.points.n; ++i) {
        const abi::Medium& m = scene.media->materials()[std::size_t(media.number(i))];
        double square = 0;
        for (int a = 0; a < shot.points.dimension && shot.u[a]; ++a) square += shot.u[a][i] * shot.u[a][i];
        most.compression = std::max(most.compression, std::abs(shot.p[i]) / bulk_modulus(m));
        most.mach = std::max(most.mach, std::sqrt(square) / m.c0);
    }
    return most;
}

}    // namespace

std::optional<std::string> beyond_linear(const Case& scene, const abi::Snapshot& shot) {
    Loudness most = loudness_of(scene, shot);
    for (const SourceUse& use : scene.sources)
        if (const abi::PlaneWave* wave = use.source->wave()) {
            const int number = scene.media->view().number_at(scene.box.dimension, wave->origin);
            const double ratio = std::abs(wave->amplitude) / bulk_modulus(scene.media->materials()[std::size_t(number)]);
            most = {std::max(most.compression, ratio), std::max(most.mach, ratio)};    // alike in a plane wave
        }
    if (most.compression <= small && most.mach <= small) return std::nullopt;
    char figures[240];
    std::snprintf(figures, sizeof figures, "the sound is beyond linear acoustics: p/(rho0 c0^2) reaches %.2g and the Mach number %.2g, and linear equations are right to about as much. "
                                           "Choose amplitudes below %g of rho0 c0^2",
                  most.compression, most.mach, small);
    return figures;
}

}    // namespace sphonic
