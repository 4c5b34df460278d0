#include "passes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sphonic {
namespace {

/// Costs in steps of fdtd of order 2 on as many points, which makes them in one pass over the fields unless something acts in its middle:
/// bodies beside that by the share of the box that is solid, layers for each component by the root of the share that they damp (thin ones
/// reach nearly as many lines). In 2-D of 60^2 to 400^2, in 3-D of 40^3 and 80^3 points.
struct Passes {
    double acting, solid, media, layers;
};
constexpr Passes in_one{0.4, 6, 0.45, 0.6}, in_two{0.15, 6, 0.45, 0.6};    // fdtd of order 2, and of others

constexpr double imposed = 6;    ///< for each point of a source that sets p, of which a sine is a good part [ns]

/// Places all over a box.
class Sample {
public:
    explicit Sample(const abi::Box& box) : dimension_(box.dimension) {
        constexpr double steps[] = {0.6180339887, 0.7548776662, 0.5698402910};    // of a sequence that fills the box evenly
        for (int axis = 0; axis < dimension_; ++axis)
            for (int i = 0; i < count; ++i) x_[axis].push_back(std::lerp(box.lower[axis], box.upper[axis], std::fmod(0.5 + i * steps[axis], 1.0)));
    }
    abi::Points points() const { return {dimension_, count, {x_[0].data(), x_[1].data(), x_[2].data()}}; }
    static constexpr int count = 1000;

private:
    int dimension_;
    std::vector<double> x_[3];
};

/// Of a box, where a source sets p.
double imposed_share(const Case& scene, const SourceUse& use) {
    const Sample sample(scene.box);
    std::vector<unsigned char> inside(Sample::count);
    use.inside(sample.points(), inside.data());
    return double(std::ranges::count(inside, 1)) / Sample::count;
}

/// Of a box, within bodies.
double solid_share(const Case& scene) {
    const Sample sample(scene.box);
    std::vector<double> distance(Sample::count), normal[3];
    double* out[3] = {};
    for (int axis = 0; axis < scene.box.dimension; ++axis) {
        normal[axis].resize(Sample::count);
        out[axis] = normal[axis].data();
    }
    double share = 0;
    for (const Obstacle& obstacle : scene.obstacles) {
        obstacle.measure(scene.box, sample.points(), distance.data(), out);
        share += double(std::ranges::count_if(distance, [](double d) { return d < 0; })) / Sample::count;
    }
    return share;
}

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

/// More for fields that do not fit into a core's own cache.
double from_outside(double bytes) {
    constexpr double own = 1e6, far = 4, dearer = 2.4;
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
    double count = of.layers * std::sqrt(damped) * (1 + d), set = 0;
    if (fdtd) count += (apart ? of.acting : 0) + of.solid * solid_share(scene) + (scene.media->several() && d > 1 ? of.media : 0);
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
