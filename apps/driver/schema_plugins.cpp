#include <sphonic/parameters.hpp>
#include <sphonic/plugin/abi/source.hpp>

#include "schema_parts.hpp"

namespace sphonic::driver::schemas {
namespace {

const std::vector<const Plugin*>& of_kind(const Plugins& plugins, const std::string& kind) {
    static const std::vector<const Plugin*> none;
    const auto found = plugins.find(kind);
    return found == plugins.end() ? none : found->second;
}

/// Sources that set values.
Names imposing(const Plugins& plugins, Registry& registry) {
    Names names;
    for (const Plugin* plugin : of_kind(plugins, "source"))
        if (with_defaults<abi::Source>(registry, *plugin)->action().sets()) names.push_back(plugin->name);
    return names;
}

void add_rule(Json& schema, const KeyRule& rule_of_keys, const Names& imposing) {
    using enum KeyRule::How;
    const Names& keys = rule_of_keys.keys;
    switch (rule_of_keys.how) {
        case required: break;    // stands with each plugin's own
        case required_to_impose: schema["allOf"].push_back(rule(where("type", object({{"enum", imposing}})), requiring(keys))); break;
        case exactly_one:
            for (const std::string& key : keys) schema["oneOf"].push_back(requiring({key}));
            break;
        case at_most_one:
            for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
                Json others = Json::object();
                for (std::size_t k = i + 1; k < keys.size(); ++k) others[keys[k]] = false;
                schema["dependentSchemas"][keys[i]] = object({{"properties", others}});
            }
    }
}

/// A plugin under "type", with the keys common to its kind.
Json typed_plugin(const Plugins& plugins, const std::string& kind, const Names& imposing = {}) {
    Names needed;
    for (const KeyRule& rule : key_rules(kind))
        if (rule.how == KeyRule::How::required) needed.insert(needed.end(), rule.keys.begin(), rule.keys.end());
    Json schema = named_plugin(plugins, kind, "type", rows_of(kind), needed);
    for (const KeyRule& rule : key_rules(kind)) add_rule(schema, rule, imposing);
    return schema;
}

}    // namespace

/// By if and then, not oneOf: a validator then complains of the one wrong member.
Json named_plugin(const Plugins& plugins, const std::string& kind, const std::string& key, const Json& beside, const Names& needed) {
    Json names = Json::array(), rules = Json::array();
    for (const Plugin* plugin : of_kind(plugins, kind)) {
        Json members = object({{key.c_str(), object({{"const", plugin->name}, {"description", plugin->doc}})}});
        add_rows(members, plugin->parameters);
        members.update(beside);
        Names required{key};
        for (const abi::ParameterInfo& row : plugin->parameters)
            if (is_required(row)) required.push_back(row.name);
        required.insert(required.end(), needed.begin(), needed.end());
        names.push_back(plugin->name);
        rules.push_back(rule(where(key, object({{"const", plugin->name}})), closed(members, required)));
    }
    Json schema = where(key, object({{"enum", names}}));
    schema["type"] = "object";
    if (!rules.empty()) schema["allOf"] = rules;
    return schema;
}

Json kind_schemas(const Plugins& plugins, Registry& registry) {
    Json defs = Json::object();
    for (const char* kind : {"viscosity", "dissipation", "reference", "method", "kernel", "boundary", "shape", "arrangement", "integrator"})
        defs[kind] = typed_plugin(plugins, kind);
    defs["source"] = typed_plugin(plugins, "source", imposing(plugins, registry));
    defs["boundary"]["properties"]["face"] = object({{"enum", faces(3)}});
    const Json form = typed_plugin(plugins, "form");
    defs["form"] = object({{"if", string}, {"then", form["properties"]["type"]}, {"else", form}});
    return defs;
}

Json vectors_of(const Plugins& plugins, const std::string& kind, const Json& schema) {
    Json members = Json::object();
    for (const Plugin* plugin : of_kind(plugins, kind))
        for (const abi::ParameterInfo& row : plugin->parameters)
            if (row.initial.type == abi::ParameterType::vector) members[row.name] = schema;
    return members;
}

Json faces(int dimension) {
    Json names = Json::array();
    for (const char axis : std::string("xyz").substr(0, std::size_t(dimension)))
        for (const char* side : {"", "_min", "_max"}) names.push_back(axis + std::string(side));
    names.push_back("all");
    return names;
}

}    // namespace sphonic::driver::schemas
