#include "plugin_rows.hpp"

#include <algorithm>

#include <sphonic/json.hpp>
#include <sphonic/parameters.hpp>

namespace sphonic::driver {
namespace {

bool is_required(const abi::ParameterInfo& row, const std::string& kind) {
    return std::ranges::any_of(key_rules(kind), [&](const KeyRule& rule) {
        return rule.how == KeyRule::How::required && std::ranges::find(rule.keys, row.name) != rule.keys.end();
    });
}

/// Null where there is none.
Json row_default(const abi::ParameterInfo& row) {
    const Json initial = to_json(row.initial);
    const bool none = sphonic::is_required(row) || initial.empty() || initial == "";
    return none ? Json(nullptr) : initial;
}

std::string shown_default(const abi::ParameterInfo& row, bool required) {
    const Json initial = row_default(row);
    return required ? "required" : initial.is_null() ? "" : initial.dump();
}

Json row_json(const abi::ParameterInfo& row, bool required) {
    return {{"name", row.name}, {"type", type_name(row.initial.type)}, {"unit", row.unit}, {"required", required},
            {"default", sphonic::is_required(row) ? Json(nullptr) : to_json(row.initial)}, {"range", range_short(row)}, {"doc", row.doc}};
}

}    // namespace

std::string shown_default(const abi::ParameterInfo& row) { return shown_default(row, sphonic::is_required(row)); }

std::string shown_default(const abi::ParameterInfo& row, const std::string& kind) { return shown_default(row, is_required(row, kind)); }

Json plugin_json(const Plugin& plugin) {
    Json json{{"kind", plugin.kind}, {"name", plugin.name}, {"doc", plugin.doc}, {"file", plugin.file.string()}, {"abi", plugin.abi}};
    json["parameters"] = Json::array();
    for (const auto& row : plugin.parameters) json["parameters"].push_back(row_json(row, sphonic::is_required(row)));
    json["common"] = Json::array();
    for (const auto& row : common_keys(plugin.kind)) json["common"].push_back(row_json(row, is_required(row, plugin.kind)));
    return json;
}

}    // namespace sphonic::driver
