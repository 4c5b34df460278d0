#include "limit_words.hpp"

#include <cmath>

#include <sphonic/shown.hpp>
#include <sphonic/stability_report.hpp>

namespace sphonic::driver {

std::string limit_words(const Case& scene, const Summary& run) {
    const std::string limit = shown(run.dt_limit) + " s (c0 dt/dx = " + shown(courant_dx(scene, run.dt_limit)) + ")";
    if (run.weak && run.dt_limit == 0)
        return "no step is stable: the worst mode grows by e in " + shown(std::ceil(double(run.steps) / run.growth)) + " steps, e^" + shown(run.growth, 3) + " in this run";
    if (run.growth_rate > 0)
        return "no step is stable: the worst motion grows by e in " + shown(std::ceil(1 / (run.growth_rate * run.dt))) + " steps, e^" +
               shown(run.growth_rate * scene.until, 3) + " in this run; beyond " + limit + " the shortest waves grow besides";
    return (run.weak ? "grows at any step, by less than e^12 in this run up to " : "stable to ") + limit;
}

}    // namespace sphonic::driver
