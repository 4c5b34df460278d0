#include "scene.hpp"

#include "particle_solver.hpp"

namespace sphonic {

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
    scene.particles = [](const void* host) { return make_particle_solver(*static_cast<const Case*>(host)); };
    for (int a = 0; a < c.box.dimension; ++a)
        for (const bool upper : {false, true}) scene.face[a][upper] = c.face(a, upper);
    scene.host = &c;
}

}    // namespace sphonic
