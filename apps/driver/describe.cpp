#include <cstdio>
#include <iostream>

#include <sphonic/json.hpp>
#include <sphonic/parameters.hpp>

#include "commands.hpp"
#include "found_plugins.hpp"
#include "plugin_rows.hpp"

namespace sphonic::driver {
namespace {

void print_row(const abi::ParameterInfo& row, const std::string& initial) {
    std::printf("  %-15s %-7s %-9s %-24s %s\n", row.name, row.unit, initial.empty() ? "-" : initial.c_str(), range_short(row).c_str(),
                row.doc);
}

void print(const Plugin& plugin) {
    std::printf("%s %s: %s\n%s\nABI %s\n", plugin.kind.c_str(), plugin.name.c_str(), plugin.doc.c_str(), plugin.file.c_str(),
                plugin.abi.c_str());
    std::printf("  %-15s %-7s %-9s %-24s\n", "key", "unit", "default", "range");
    for (const auto& row : plugin.parameters) print_row(row, shown_default(row));
}

void print_common(const std::string& kind) {
    if (!common_keys(kind).empty()) std::printf("and, for every %s:\n", kind.c_str());
    for (const auto& row : common_keys(kind)) print_row(row, shown_default(row, kind));
}

void print(const std::vector<const Plugin*>& plugins) {
    for (std::size_t i = 0; i < plugins.size(); ++i) {
        if (i > 0) std::printf("\n");
        print(*plugins[i]);
        if (i + 1 == plugins.size() || plugins[i + 1]->kind != plugins[i]->kind) print_common(plugins[i]->kind);
    }
}

}    // namespace

int describe(const DescribeOptions& options) {
    if (!options.kind.empty()) require_kind(options.kind, "describe");
    Registry registry(Registry::search_path(options.plugin_path));
    const bool one = !options.name.empty();
    FoundPlugins found;
    if (one)
        found.plugins.push_back(&registry.find(options.kind, options.name, "describe"));
    else
        found = load_found(registry, "describe", options.kind);
    Json all = Json::array();
    for (const Plugin* plugin : found.plugins) all.push_back(plugin_json(*plugin));
    if (options.json)
        std::cout << json_text(one ? all[0] : all);
    else if (options.markdown)
        std::cout << plugins_markdown(found.plugins);
    else
        print(found.plugins);
    return found.exit_code();
}

}    // namespace sphonic::driver
