#include <cstdio>
#include <iostream>

#include <unistd.h>

#include <sphonic/cost_model.hpp>
#include <sphonic/json.hpp>

#include "commands.hpp"

namespace sphonic::driver {

int calibrate(const Common& options) {
    Registry registry(Registry::search_path(options.plugin_path));
    const bool terminal = isatty(STDERR_FILENO);
    const CostModel costs = sphonic::calibrate(registry, [terminal](double share) {
        if (terminal) std::fprintf(stderr, "\rmeasuring: %3.0f %%%s", 100 * share, share < 1 ? "" : "\r\033[K");
    });
    save_costs(costs, costs_file());
    if (options.json) {
        std::cout << json_text(to_json(costs));
        return 0;
    }
    std::printf("%s, %.0f MB of cache; nanoseconds of one thread for a particle and evaluation\n", costs.machine.c_str(), 1e-6 * costs.cache);
    std::printf("  %-20s %8s %14s %16s %14s\n", "tier, dimension", "fixed", "per neighbour", "with viscosity", "from memory");
    for (const auto& [tier, c] : costs.units)
        std::printf("  %-20s %8.3f %14.4f %16.4f %14.4f\n", tier.c_str(), c.fixed, c.per_neighbour, c.per_neighbour + c.viscous, c.from_memory);
    std::printf("kept in %s for check, study and plan\n", costs_file().c_str());
    return 0;
}

}    // namespace sphonic::driver
