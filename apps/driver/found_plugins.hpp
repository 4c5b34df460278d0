#pragma once
#include <string>
#include <vector>

#include <sphonic/registry.hpp>

namespace sphonic::driver {

/// Plugins by kind and name, as far as they load.
struct FoundPlugins {
    std::vector<const Plugin*> plugins;
    int refused = 0;

    /// What is left for a command that did the rest.
    int exit_code() const;
};

/// All plugins found, or those of a kind; what cannot be loaded is logged. `place` is for messages.
FoundPlugins load_found(Registry& registry, const std::string& place, const std::string& kind = {});

/// Refuses a kind that there is not, with the nearest.
void require_kind(const std::string& kind, const std::string& place);

}    // namespace sphonic::driver
