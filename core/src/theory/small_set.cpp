#include "small_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>

namespace sphonic {
namespace {

using Sites = std::array<long, 3>;

constexpr long most_samples = 100'000;    ///< of the media, in search of a jump
constexpr long most_particles = 4000;     ///< of a set that is taken whole

/// Spacings a side: of the fewest, or as many as the kernel reaches to either side, and two.
long side(const Case& scene) {
    constexpr long fewest[4] = {0, 40, 10, 6};
    return std::max(fewest[scene.box.dimension], 2 * long(std::ceil(scene.radius() / scene.box.dx)) + 2);
}

/// The lattice site beside the strongest jump of rho0 c0 that a walk over some of the sites finds.
Sites strongest_jump(const Case& scene) {
    const abi::Box& box = scene.box;
    const auto& media = scene.media->list();
    long stride = 1, total = 1;
    for (int a = 0; a < box.dimension; ++a) total *= box.count[a];
    while (total / std::lround(std::pow(double(stride), box.dimension - 1)) > most_samples) ++stride;
    Sites best{}, at{};
    double strongest = 0;
    int before = 0;
    for (at[2] = 0; at[2] < box.count[2]; at[2] += stride)
        for (at[1] = 0; at[1] < box.count[1]; at[1] += stride)
            for (at[0] = 0; at[0] < box.count[0]; ++at[0]) {
                double x[3];
                for (int a = 0; a < 3; ++a) x[a] = box.lower[a] + double(at[std::size_t(a)]) * box.dx;
                int number = 0;
                scene.media->find({.dimension = box.dimension, .n = 1, .x = {x, x + 1, x + 2}}, &number);
                const auto impedance = [&](int m) { return media[std::size_t(m)].rho0 * media[std::size_t(m)].c0; };
                const double jump = std::abs(std::log(impedance(number) / impedance(before)));
                if (jump > strongest) strongest = jump, best = at;
                before = number;
            }
    return best;
}

/// Ends of the piece along an axis, `n` spacings long; where that is no whole number of an arrangement's periods, the `fewer`-th
/// of the longer pieces that divide the box evenly.
std::pair<double, double> piece(const Case& scene, int axis, long n, long centre, int fewer) {
    const abi::Box& box = scene.box;
    const double whole = box.upper[axis] - box.lower[axis], wanted = double(n) * box.dx;
    if (wanted >= whole) return {box.lower[axis], box.upper[axis]};
    const double length = fewer == 0 ? wanted : whole / std::max(1.0, std::floor(whole / wanted) - fewer + 1);
    const double most = std::floor((whole - length) / box.dx), begin = std::clamp(double(centre - n / 2), 0.0, std::max(0.0, most));
    return {box.lower[axis] + begin * box.dx, box.lower[axis] + begin * box.dx + length};
}

bool is_solid(const Case& scene, const abi::Points& point) {
    double distance = 1, normal[3];
    double* const to[3] = {normal, normal + 1, normal + 2};
    bool solid = false;
    for (const Obstacle& obstacle : scene.obstacles) obstacle.measure(scene.box, point, &distance, to), solid = solid || distance <= 0;
    return solid;
}

/// True if sources set all that a walk over some of a face's sites finds, or it is solid: nothing there can grow.
bool is_held(const Case& scene, int axis, bool upper) {
    constexpr int samples = 8;
    const abi::Box& box = scene.box;
    bool held = true;
    for (int i = 0; i < samples * samples; ++i) {
        double x[3] = {0, 0, 0}, share[2] = {double(i % samples) / (samples - 1), double(i / samples) / (samples - 1)};
        for (int a = 0, s = 0; a < box.dimension; ++a)
            x[a] = a == axis ? (upper ? box.upper[a] : box.lower[a]) : box.lower[a] + share[s++] * (box.upper[a] - box.lower[a]);
        const abi::Points point{.dimension = box.dimension, .n = 1, .x = {x, x + 1, x + 2}};
        unsigned char inside = 0;
        bool any = is_solid(scene, point);
        for (const SourceUse& use : scene.sources)
            if (use.source->action().sets()) use.inside(point, &inside), any = any || inside;
        held = held && any;
    }
    return held;
}

/// What the piece has at a face: the case's boundary, or a rigid wall behind what damps and in the place of what sources set.
Json closing(const Case& scene, int axis, bool upper, bool closed) {
    const abi::Boundary* face = scene.face(axis, upper);
    if (!face || face->closure() == abi::Closure::free) return {{"type", closed || is_held(scene, axis, upper) ? "rigid" : "free"}};
    if (face->damping(0, scene.medium) > 0) return {{"type", "rigid"}};
    return (*scene.resolved)["boundaries"][std::size_t(scene.boundary_of[axis][upper])];
}

Json quiet_document(const Case& scene, double dt, bool closed) {
    Json document = *scene.resolved;
    for (const char* part : {"sources", "obstacles", "initial", "reference", "output", "provenance"}) document.erase(part);
    for (const char* choice : {"courant", "courant_length", "safety"}) document["integrator"].erase(choice);
    document["integrator"]["dt"] = dt;
    document["integrator"]["unstable"] = "allow";
    Json faces = Json::array();
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true}) {
            if (scene.box.periodic[a] && upper) continue;
            const std::string name = std::string(1, "xyz"[a]) + (scene.box.periodic[a] ? "" : upper ? "_max" : "_min");
            faces.push_back(closing(scene, a, upper, closed));
            faces.back()["face"] = name;
        }
    document["boundaries"] = faces;
    return document;
}

}    // namespace

std::optional<Case> small_set(const Case& scene, double dt, bool closed) {
    Json document = quiet_document(scene, dt, closed);
    const Sites centre = scene.media->several() ? strongest_jump(scene) : Sites{};
    const auto box_of = [&](int fewer) {
        document["particles"]["lower"] = document["particles"]["upper"] = Json::array();
        for (int a = 0; a < scene.box.dimension; ++a) {
            const auto [lower, upper] = piece(scene, a, side(scene), centre[std::size_t(a)], fewer);
            document["particles"]["lower"].push_back(a ? lower : scene.place(lower));
            document["particles"]["upper"].push_back(a ? upper : scene.place(upper));
        }
    };
    for (int fewer = 0; fewer < 4; ++fewer) try {
            box_of(fewer);
            Case small = load_case(document, scene.file, *scene.registry);
            small.threads = 1;
            if (small.particles <= most_particles) return small;
        } catch (const Error&) {    // an arrangement that does not fit into this box
        }
    return std::nullopt;
}

}    // namespace sphonic
