#include "sites.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "mirror_particles.hpp"

namespace sphonic {
namespace {

/// Uniform random displacements. Bounded axes keep their particles inside, and those on a face on it.
void displace(const Case& scene, Places& x) {
    std::mt19937_64 bits(std::uint64_t(scene.seed));
    const abi::Box& box = scene.box;
    for (std::size_t i = 0; i < x[0].size(); ++i)
        for (int a = 0; a < box.dimension; ++a) {
            const double random = double(bits() >> 11) * 0x1p-53;    // the library's distributions differ between compilers
            if (!box.periodic[a] && (on_end(scene, a, false, x[a][i]) || on_end(scene, a, true, x[a][i]))) continue;
            x[a][i] += scene.jitter * box.dx * (2 * random - 1);
            if (!box.periodic[a]) x[a][i] = std::clamp(x[a][i], end_of_set(scene, a, false), end_of_set(scene, a, true));
        }
}

}    // namespace

Sites::Sites(const Case& scene) : cut(scene.obstacles.size()) {
    double* x[3] = {};
    for (int a = 0; a < scene.box.dimension; ++a) {
        own[a].resize(std::size_t(scene.arrangement->size(scene.box)));
        x[a] = own[a].data();
    }
    scene.arrangement->place(scene.box, x);
    if (scene.jitter > 0) displace(scene, own);
    if (scene.obstacles.empty()) return;
    Places all;
    for (int a = 0; a < 3; ++a) all[a].swap(own[a]);
    separate(scene, all);
}

void Sites::separate(const Case& scene, Places& all) {
    const std::size_t n = all[0].size();
    std::vector<char> taken(n);
    std::vector<double> distance(n), normal[3];
    abi::Points points{.dimension = scene.box.dimension, .n = int(n)};
    double* out[3] = {};
    for (int a = 0; a < scene.box.dimension; ++a) {
        normal[a].resize(n);
        out[a] = normal[a].data();
        points.x[a] = all[a].data();
    }
    for (std::size_t k = 0; k < scene.obstacles.size(); ++k) {
        scene.obstacles[k].measure(scene.box, points, distance.data(), out);
        for (std::size_t i = 0; i < n; ++i) {
            if (distance[i] >= -on_wall * scene.box.dx) continue;
            taken[i] = 1;
            ++cut[k];
        }
    }
    for (int a = 0; a < scene.box.dimension; ++a)
        for (std::size_t i = 0; i < n; ++i) (taken[i] ? solid : own)[a].push_back(all[a][i]);
}

}    // namespace sphonic
