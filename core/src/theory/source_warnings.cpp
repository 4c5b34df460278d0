#include <algorithm>
#include <array>
#include <cmath>

#include <sphonic/prediction.hpp>
#include <sphonic/shown.hpp>

#include "carried_wave.hpp"

namespace sphonic {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double noticed = 0.02;     ///< error of a wave's speed: a quarter of a wave after twelve
constexpr double coarse = 6;         ///< points per wavelength, where nothing better is known
constexpr long most_sites = 100'000, most_samples = 20'000, fewest_crossings = 4;

/// Some of the box's sites, by axis.
std::array<std::vector<double>, 3> some_sites(const abi::Box& box) {
    long stride = 1, total = 1;
    for (int a = 0; a < box.dimension; ++a) total *= box.count[a];
    while (double(total) / std::pow(double(stride), box.dimension) > most_sites) ++stride;
    std::array<std::vector<double>, 3> x;
    const auto last = [&](int a) { return a < box.dimension ? box.count[a] : 1; };
    for (long k = 0; k < last(2); k += stride)
        for (long j = 0; j < last(1); j += stride)
            for (long i = 0; i < last(0); i += stride) {
                const long at[3] = {i, j, k};
                for (std::size_t a = 0; a < 3; ++a) x[a].push_back(int(a) < box.dimension ? box.lower[a] + double(at[a]) * box.dx : 0);
            }
    return x;
}

/// Of p that a source imposes, at one of its particles: half the number of its changes of sign per time.
double counted_frequency(const Case& scene, const SourceUse& use, double dt) {
    const auto sites = some_sites(scene.box);
    const abi::Points points{.dimension = scene.box.dimension, .n = int(sites[0].size()), .x = {sites[0].data(), sites[1].data(), sites[2].data()}};
    std::vector<unsigned char> inside(sites[0].size());
    use.inside(points, inside.data());
    const auto i = std::ranges::find(inside, 1) - inside.begin();
    if (i == long(inside.size())) return 0;
    const abi::Points one{.dimension = points.dimension, .n = 1, .x = {points.x[0] + i, points.x[1] + i, points.x[2] + i}};
    const long samples = std::min(most_samples, long(scene.until / dt));
    long crossings = 0;
    double before = 0;
    for (long s = 0; s < samples; ++s) {
        double p = 0;
        use.source->evaluate(double(s) * dt, one, {.p = &p, .u = {}});
        crossings += p * before < 0;
        if (p != 0) before = p;
    }
    return crossings < fewest_crossings ? 0 : pi * double(crossings) / (double(samples) * dt);
}

double highest_frequency(const Case& scene, const SourceUse& use, double dt) {
    const double told = use.source->highest_frequency();
    return told > 0 || !use.source->action().sets_pressure ? told : counted_frequency(scene, use, dt);
}

std::string remedy(const Case& scene) {
    for (const Variable& v : scene.equations.variables)
        for (const Term& term : v.terms)
            if (!term.fitted.empty()) return ". Choose a smaller dx, or a wider support of the form";
    return scene.method->meshfree() ? ". Choose a smaller dx, a smaller h/dx or band_fitted_acoustics" : ". Choose a smaller dx";
}

/// Of one frequency in one medium, with how bad it is; nothing where it travels well.
std::pair<double, std::string> misfortune(const Case& scene, double omega, const double* direction, double dt, int medium) {
    const double c0 = scene.media->list()[std::size_t(medium)].c0, points = 2 * pi * c0 / (omega * scene.box.dx);
    const std::string has = "has " + shown(points, 3) + " points per wavelength";
    if (scene.method->meshfree() && !scene.arrangement->regular()) {
        if (points >= coarse) return {};
        return {1 / points, has + ": waves this short travel wrongly or not at all"};
    }
    double top = 0;
    const auto k = carried_wave_number(scene, omega, direction, dt, medium, &top);
    if (!k) return {1 + 1 / points, has + ", and this set carries no waves of less than " + shown(2 * pi * c0 / (top * scene.box.dx), 3)};
    const double low = 0.01 * *k, error = omega / *k / (travelling_mode(scene, low, direction, dt, undamped, medium).omega / low) - 1;
    if (std::abs(error) < noticed) return {};
    return {std::abs(error), has + ", and its waves travel " + shown(100 * std::abs(error), 2) + " % " + (error < 0 ? "slower" : "faster") + " than long ones"};
}

}    // namespace

std::vector<std::string> source_warnings(const Case& scene, double dt) {
    std::vector<std::string> warnings;
    const double x_axis[3] = {1, 0, 0};
    for (std::size_t s = 0; s < scene.sources.size(); ++s) {
        const SourceUse& use = scene.sources[s];
        const double omega = highest_frequency(scene, use, dt);
        if (!(omega > 0)) continue;
        std::pair<double, std::string> worst;
        for (std::size_t m = 0; m < scene.media->list().size(); ++m)
            worst = std::max(worst, misfortune(scene, omega, use.source->wave() ? use.source->wave()->direction : x_axis, dt, int(m)));
        if (worst.first > 0)
            warnings.push_back("/sources/" + std::to_string(s) + ": its highest frequency, " + shown(omega / (2 * pi)) + " Hz, " + worst.second + remedy(scene));
    }
    return warnings;
}

}    // namespace sphonic
