#include <algorithm>
#include <cstdio>
#include <iostream>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/log.hpp>
#include <sphonic/parameters.hpp>
#include <sphonic/registry.hpp>

#include "commands.hpp"

namespace sphonic::driver {
namespace {

Json row_json(const abi::ParameterInfo& row) {
    Json json{{"name", row.name}, {"type", type_name(row.initial.type)}, {"unit", row.unit}, {"required", is_required(row) && row.initial.real == row.initial.real}};
    json["default"] = is_required(row) ? Json(nullptr) : to_json(row.initial);
    json["range"] = range_short(row);
    json["doc"] = row.doc;
    return json;
}

Json plugin_json(const Plugin& plugin) {
    Json json{{"kind", plugin.kind}, {"name", plugin.name}, {"doc", plugin.doc}, {"file", plugin.file.string()}, {"abi", plugin.abi}};
    json["parameters"] = Json::array();
    for (const auto& row : plugin.parameters) json["parameters"].push_back(row_json(row));
    json["common"] = Json::array();
    for (const auto& row : common_keys(plugin.kind)) json["common"].push_back(row_json(row));
    return json;
}

void print_rows(std::span<const abi::ParameterInfo> rows, bool common) {
    for (const auto& row : rows) {
        const Json initial = to_json(row.initial);
        std::string shown = is_required(row) ? (common ? "-" : "required") : initial.dump();
        if (shown == "[]" || shown == "\"\"") shown = "-";
        std::printf("  %-15s %-7s %-9s %-24s %s\n", row.name, row.unit, shown.c_str(), range_short(row).c_str(), row.doc);
    }
}

}    // namespace

int list(const Common& options) {
    Registry registry(Registry::search_path(options.plugin_path));
    Json all = Json::array();
    std::string last;
    int refused = 0;
    for (const auto& [kind, name] : registry.found()) {
        try {
            const Plugin& plugin = registry.find(kind, name, "list");
            all.push_back(plugin_json(plugin));
            if (options.json) continue;
            if (kind != last) std::printf("%s%s\n", last.empty() ? "" : "\n", kind.c_str());
            last = kind;
            std::printf("  %-20s %s\n", name.c_str(), plugin.doc.c_str());
        } catch (const Error& e) {
            log::error(e.what());
            ++refused;
        }
    }
    if (options.json) std::cout << json_text(all);
    return refused ? int(Fault::plugin) : 0;
}

int describe(const Common& options, const std::string& kind, const std::string& name) {
    Registry registry(Registry::search_path(options.plugin_path));
    const auto kinds = plugin_kinds();
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
        std::string known;
        for (const auto& k : kinds) known += (known.empty() ? "" : ", ") + k;
        throw Error(Fault::input, "describe", "there is no plugin kind \"" + kind + "\"", "Known: " + known);
    }
    const Plugin& plugin = registry.find(kind, name, "describe");
    if (options.json) {
        std::cout << json_text(plugin_json(plugin));
        return 0;
    }
    std::printf("%s %s: %s\n%s\nABI %s\n", kind.c_str(), name.c_str(), plugin.doc.c_str(), plugin.file.c_str(), plugin.abi.c_str());
    std::printf("  %-15s %-7s %-9s %-24s\n", "key", "unit", "default", "range");
    print_rows(plugin.parameters, false);
    if (!common_keys(kind).empty()) std::printf("and, for every %s:\n", kind.c_str());
    print_rows(common_keys(kind), true);
    return 0;
}

}    // namespace sphonic::driver
