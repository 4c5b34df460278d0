#include "parallel.hpp"

#include <cmath>

#include <omp.h>

#include <sphonic/stability.hpp>

#include "machine.hpp"

namespace sphonic {

int threads_for(const Case& scene) {
    if (scene.threads > 0) return scene.threads;
    // pairs per thread and evaluation that take some hundred microseconds, several times what waking a thread does; stencils are fast
    const double worthwhile_pairs = scene.regular() && !is_viscous(scene) ? 4e6 : 4e5;
    const double reach = scene.radius() / scene.box.dx, d = scene.box.dimension;
    const double neighbours = std::pow(2 * reach, d), pairs = neighbours * double(scene.particles);
    return std::max(1, int(std::min({pairs / worthwhile_pairs, double(omp_get_max_threads()), available_cores()})));
}

}    // namespace sphonic
