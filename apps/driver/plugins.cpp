#include <algorithm>
#include <cstdio>
#include <iostream>
#include <limits>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/log.hpp>
#include <sphonic/registry.hpp>

#include "commands.hpp"

namespace sphonic::driver {
namespace {

const char* type_name(abi::ParameterType type) {
    constexpr const char* names[] = {"number", "integer", "boolean", "string", "list of numbers"};
    return names[int(type)];
}

Json value_json(const abi::Value& value) {
    switch (value.type) {
        case abi::ParameterType::real: return value.real;
        case abi::ParameterType::integer: return value.integer;
        case abi::ParameterType::boolean: return value.boolean;
        case abi::ParameterType::text: return value.text;
        case abi::ParameterType::vector: break;
    }
    return Json(nullptr);
}

bool is_required(const abi::ParameterInfo& row) {
    return row.initial.type == abi::ParameterType::real && (row.initial.real < row.lower || row.initial.real > row.upper);
}

std::string range(const abi::ParameterInfo& row) {
    if (row.choices[0]) return row.choices;
    if (row.initial.type != abi::ParameterType::real && row.initial.type != abi::ParameterType::integer) return "";
    const bool open = row.lower == std::numeric_limits<double>::min();
    const std::string low = open ? "> 0" : row.lower > -std::numeric_limits<double>::infinity() ? ">= " + Json(row.lower).dump() : "";
    const std::string high = row.upper < std::numeric_limits<double>::infinity() ? "<= " + Json(row.upper).dump() : "";
    return low + (low.empty() || high.empty() ? "" : ", ") + high;
}

Json row_json(const abi::ParameterInfo& row) {
    Json json{{"name", row.name}, {"type", type_name(row.initial.type)}, {"unit", row.unit}, {"required", is_required(row)}};
    json["default"] = is_required(row) ? Json(nullptr) : value_json(row.initial);
    json["range"] = range(row);
    json["doc"] = row.doc;
    return json;
}

Json plugin_json(const Plugin& plugin) {
    Json json{{"kind", plugin.kind}, {"name", plugin.name}, {"doc", plugin.doc}, {"file", plugin.file.string()}, {"abi", plugin.abi}};
    json["parameters"] = Json::array();
    for (const auto& row : plugin.parameters) json["parameters"].push_back(row_json(row));
    return json;
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
    if (plugin.parameters.empty()) std::printf("no parameters\n");
    for (const auto& row : plugin.parameters) {
        const std::string initial = is_required(row) ? "required" : value_json(row.initial).dump();
        std::printf("  %-14s %-8s default %-10s %-16s %s\n", row.name, row.unit, initial == "null" ? "none" : initial.c_str(),
                    range(row).c_str(), row.doc);
    }
    return 0;
}

}    // namespace sphonic::driver
