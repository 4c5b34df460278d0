#include <cstdio>
#include <iostream>

#include <sphonic/json.hpp>

#include "commands.hpp"
#include "found_plugins.hpp"
#include "plugin_rows.hpp"

namespace sphonic::driver {

int list(const Common& options) {
    Registry registry(Registry::search_path(options.plugin_path));
    const FoundPlugins found = load_found(registry, "list");
    if (options.json) {
        Json all = Json::array();
        for (const Plugin* plugin : found.plugins) all.push_back(plugin_json(*plugin));
        std::cout << json_text(all);
        return found.exit_code();
    }
    std::string last;
    for (const Plugin* plugin : found.plugins) {
        if (plugin->kind != last) std::printf("%s%s\n", last.empty() ? "" : "\n", plugin->kind.c_str());
        last = plugin->kind;
        std::printf("  %-20s %s\n", plugin->name.c_str(), plugin->doc.c_str());
    }
    return found.exit_code();
}

}    // namespace sphonic::driver
