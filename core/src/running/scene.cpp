#include "scene.hpp"

#include "particle_solver.hpp"
#include "sites.hpp"
#include "wall_view.hpp"

namespace sphonic {
namespace {

/// Of points in several bodies, the last.
void find_bodies(const Case& scene, const abi::Points& points, abi::Body* out) {
    constexpr abi::Body kinds[] = {abi::Body::rigid, abi::Body::soft, abi::Body::free};    // as Obstacle::Wall
    std::fill(out, out + points.n, abi::Body::none);
    Places at;
    for (int a = 0; a < points.dimension; ++a) at[a].assign(points.x[a], points.x[a] + points.n);
    for (const Obstacle& obstacle : scene.obstacles) {
        const WallView view(scene, obstacle, at);
        for (std::size_t i = 0; i < view.distance.size(); ++i)
            if (view.distance[i] < -on_wall * scene.box.dx) out[i] = kinds[std::size_t(obstacle.wall)];
    }
}

}    // namespace

SceneView::SceneView(const Case& c) {
    const auto inside = [](const void* host, const abi::Points& points, unsigned char* out) {
        static_cast<const SourceUse*>(host)->inside(points, out);
    };
    const auto nothing = [](const void* host) { static_cast<const SourceUse*>(host)->reaches_nothing(); };
    for (const SourceUse& use : c.sources) sources.push_back({use.source.get(), inside, nothing, &use});
    scene = {.box = c.box, .medium = c.medium, .media = c.media->view(), .until = c.until, .sources = sources.data(), .source_count = int(sources.size())};
    scene.initial = [](const void* host, const char* field, int axis, const abi::Points& points, double* out) {
        return static_cast<const Case*>(host)->initial_values(field, axis, points, out);
    };
    if (!c.obstacles.empty())
        scene.bodies = [](const void* host, const abi::Points& points, abi::Body* out) { find_bodies(*static_cast<const Case*>(host), points, out); };
    scene.particles = [](const void* host) { return make_particle_solver(*static_cast<const Case*>(host)); };
    for (int a = 0; a < c.box.dimension; ++a)
        for (const bool upper : {false, true}) scene.face[a][upper] = c.face(a, upper);
    scene.host = &c;
}

}    // namespace sphonic
