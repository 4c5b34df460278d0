#include "passes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sphonic {
namespace {

/// Costs in steps of fdtd of order 2 on as many points, which makes them in one pass over the fields unless something acts in its middle:
/// in 2-D of 128^2 to 2048^2, in 3-D of 64^3 and 128^3 points. A layer's is for each component and point in it, the media's for each axis
/// beyond the first.
struct Passes {
    double acting, bodies, media, layers;
};
constexpr Passes in_one{0.45, 0.1, 1, 0.8}, in_two{0, 0.15, 1, 0.8};    // fdtd of order 2, and of others

constexpr double imposed = 6;    ///< for each point of a source that sets p, of which a sine is a good part [ns]

/// Of a box, in which layers damp.
double damped_share(const Case& scene) {
    constexpr int samples = 100;
    double free = 1;
    for (int axis = 0; axis < scene.box.dimension; ++axis) {
        const double length = scene.box.upper[axis] - scene.box.lower[axis];
        int damped = 0;
        for (const bool upper : {false, true})
            if (const abi::Boundary* face = scene.face(axis, upper))
                for (int i = 0; i < samples; ++i) damped += face->damping(length * (i + 0.5) / samples, scene.medium) > 0;
        free *= 1 - std::min(1.0, double(damped) / samples);
    }
    return 1 - free;
}

/// Of a box, where a source sets p, by a sample of places.
double imposed_share(const Case& scene, const SourceUse& use) {
    constexpr int count = 1000;
    constexpr double steps[] = {0.6180339887, 0.7548776662, 0.5698402910};    // of a sequence that fills the box evenly
    std::vector<double> x[3];
    for (int axis = 0; axis < scene.box.dimension; ++axis)
        for (int i = 0; i < count; ++i) x[axis].push_back(std::lerp(scene.box.lower[axis], scene.box.upper[axis], std::fmod(0.5 + i * steps[axis], 1.0)));
    std::vector<unsigned char> inside(count);
    use.inside({scene.box.dimension, count, {x[0].data(), x[1].data(), x[2].data()}}, inside.data());
    return double(std::ranges::count(inside, 1)) / count;
}

/// More for fields that do not fit into a core's own cache.
double from_outside(double bytes) {
    constexpr double own = 1e6, far = 8, dearer = 1.8;
    return 1 + (dearer - 1) * std::clamp(std::log(bytes / own) / std::log(far), 0.0, 1.0);
}

long largest_prime(long n) {
    long largest = 1;
    for (long p = 2; p * p <= n; ++p)
        for (; n % p == 0; n /= p) largest = p;
    return std::max(largest, n);
}

}    // namespace

double passes(const CostModel& costs, const Case& scene, const Summary& prepared) {
    const int d = scene.box.dimension;
    const UnitCost* grid = costs.find("fdtd", d);
    if (!grid) return 0;
    const bool fdtd = prepared.tier == "fdtd";
    const Passes& of = fdtd && prepared.neighbours_mean <= 2 * d ? in_one : in_two;
    const double damped = damped_share(scene);
    const auto acts = [](const SourceUse& use) { return use.source->action().adds || use.source->action().sets_velocity; };
    const bool apart = damped > 0 || !scene.obstacles.empty() || std::ranges::any_of(scene.sources, acts);
    double count = of.layers * damped * (1 + d), set = 0;
    if (fdtd) count += (apart ? of.acting : 0) + (scene.obstacles.empty() ? 0 : of.bodies) + (scene.media->several() ? of.media * (d - 1) : 0);
    for (const SourceUse& use : scene.sources)
        if (use.source->action().sets_pressure) set += imposed * imposed_share(scene, use);
    return count * (grid->fixed + grid->per_neighbour * 2 * d) * from_outside(8.0 * (1 + d) * double(prepared.particles)) + set;
}

double transform_factor(const Case& scene, const std::string& tier) {
    if (!tier.starts_with("kspace")) return 1;
    double sum = 0;
    for (int axis = 0; axis < scene.box.dimension; ++axis) {
        const long prime = largest_prime(scene.box.count[axis]);
        sum += prime <= 2 ? 1 : prime <= 5 ? 1.4 : prime <= 13 ? 2.5 : prime <= 37 ? 4 : 7;    // 20^3 to 64^3, 64^2 to 257^2 points
    }
    return sum / scene.box.dimension;
}

}    // namespace sphonic
