#include "scene.hpp"

#include "particle_solver.hpp"

namespace sphonic {

SceneView::SceneView(const Case& c) {
    const auto inside = [](const void* region, const abi::Points& points, unsigned char* out) {
        double x[3] = {0, 0, 0};
        for (int i = 0; i < points.n; ++i) {
            for (int a = 0; a < points.dimension; ++a) x[a] = points.x[a][i];
            out[i] = static_cast<const Region*>(region)->contains(x);
        }
    };
    for (const SourceUse& use : c.sources) sources.push_back({use.source.get(), inside, &use.region});
    scene = {.box = c.box, .medium = c.medium, .until = c.until, .sources = sources.data(), .source_count = int(sources.size())};
    scene.initial = [](const void* host, const char* field, int axis, const abi::Points& points, double* out) {
        return static_cast<const Case*>(host)->initial_values(field, axis, points, out);
    };
    scene.particles = [](const void* host) { return make_particle_solver(*static_cast<const Case*>(host)); };
    scene.host = &c;
}

}    // namespace sphonic
