/// The JSON Schema of a case, made from the tables that also make parsing, range errors and `describe`.
/// It holds every rule that looks at one object; what looks across objects (a kernel's reach, regions, the step) is
/// left to `check`.
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <ranges>
#include <string_view>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/log.hpp>
#include <sphonic/parameters.hpp>
#include <sphonic/plugin/abi/method.hpp>
#include <sphonic/registry.hpp>
#include <sphonic/version.hpp>

#include "commands.hpp"

namespace sphonic::driver {
namespace {

using Type = abi::ParameterType;
using Names = std::vector<std::string>;
/// The plugins of each kind, by name.
using Plugins = std::map<std::string, std::vector<const Plugin*>>;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double positive = std::numeric_limits<double>::min();

abi::ParameterInfo number(const char* name, const char* unit, double lower, const char* doc,
                          double initial = std::numeric_limits<double>::quiet_NaN()) {
    return {name, unit, lower, infinite, doc, "", {.type = Type::real, .real = initial}};
}

Json object(std::initializer_list<std::pair<const char*, Json>> members) {
    Json out = Json::object();
    for (const auto& [name, value] : members) out[name] = value;
    return out;
}

/// An object of these members and no others.
Json closed(const Json& members, const Names& required = {}) {
    Json out = object({{"type", "object"}, {"properties", members}});
    if (!required.empty()) out["required"] = required;
    out["additionalProperties"] = false;
    return out;
}

Json with(Json schema, const char* key, const Json& value) {
    schema[key] = value;
    return schema;
}
Json described(Json schema, const char* text) { return with(std::move(schema), "description", text); }
Json list_of(const Json& items) { return object({{"type", "array"}, {"items", items}}); }
Json reference(const std::string& name) { return object({{"$ref", "#/$defs/" + name}}); }
Json requiring(const Names& names) { return object({{"required", names}}); }
Json rule(const Json& condition, const Json& consequence) { return object({{"if", condition}, {"then", consequence}}); }
const Json string = object({{"type", "string"}});

/// An object whose member `key` has this value.
Json where(const std::string& key, const Json& value) {
    Json member = Json::object();
    member[key] = value;
    return object({{"properties", member}, {"required", Names{key}}});
}

void bound(Json& schema, const abi::ParameterInfo& row) {
    const auto limit = [&](double x) { return row.initial.type == Type::integer ? Json(std::int64_t(x)) : Json(x); };
    if (row.lower == positive)
        schema["exclusiveMinimum"] = 0;
    else if (std::isfinite(row.lower))
        schema["minimum"] = limit(row.lower);
    if (std::isfinite(row.upper)) schema["maximum"] = limit(row.upper);
}

Json type_of(const abi::ParameterInfo& row) {
    if (row.initial.type == Type::vector) {
        Json items = object({{"type", "number"}});
        bound(items, row);
        return with(with(list_of(items), "minItems", 1), "maxItems", 3);
    }
    Json schema = object({{"type", type_name(row.initial.type)}});
    if (row.initial.type == Type::real || row.initial.type == Type::integer) bound(schema, row);
    if (row.initial.type == Type::text && row.choices[0]) {
        schema["enum"] = Json::array();
        for (const auto choice : std::views::split(std::string_view(row.choices), '|'))
            schema["enum"].push_back(std::string(choice.begin(), choice.end()));
    }
    return schema;
}

/// One row of a table: type, range, default, and "[unit] what it is".
Json value_schema(const abi::ParameterInfo& row) {
    Json schema = type_of(row);
    const Json initial = to_json(row.initial);
    const bool none = is_required(row) || initial.empty() || initial == "";
    if (!none) schema["default"] = initial;
    const std::string unit = row.unit;
    schema["description"] = (unit == "1" ? "" : "[" + unit + "] ") + row.doc;
    return schema;
}

void add_rows(Json& members, std::span<const abi::ParameterInfo> rows) {
    for (const abi::ParameterInfo& row : rows) members[row.name] = value_schema(row);
}

/// An object in which `key` names a plugin whose parameters stand beside it, and `beside` whatever the plugin is.
/// By if and then, not oneOf: a validator then complains of the one wrong member.
Json named_plugin(const Plugins& plugins, const std::string& kind, const std::string& key, const Json& beside,
                  const Names& needed = {}) {
    Json names = Json::array(), rules = Json::array();
    if (const auto found = plugins.find(kind); found != plugins.end())
        for (const Plugin* plugin : found->second) {
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

/// A plugin under "type", with the keys common to its kind.
Json typed_plugin(const Plugins& plugins, const std::string& kind, const Names& needed = {}) {
    Json common = Json::object();
    add_rows(common, common_keys(kind));
    return named_plugin(plugins, kind, "type", common, needed);
}

Json faces(int dimension) {
    Json names = Json::array();
    for (const char axis : std::string("xyz").substr(0, std::size_t(dimension)))
        for (const char* side : {"", "_min", "_max"}) names.push_back(axis + std::string(side));
    names.push_back("all");
    return names;
}

/// The kinds, with the reader's rules on which of the common keys must stand and which exclude each other.
Json kind_schemas(const Plugins& plugins) {
    Json defs = Json::object();
    for (const char* kind : {"viscosity", "reference", "method"}) defs[kind] = typed_plugin(plugins, kind);
    defs["kernel"] = typed_plugin(plugins, "kernel");
    defs["kernel"]["oneOf"] = Json::array({requiring({"h"}), requiring({"h_over_dx"})});
    defs["source"] = typed_plugin(plugins, "source", {"region"});
    defs["boundary"] = typed_plugin(plugins, "boundary", {"face"});
    defs["boundary"]["properties"]["face"] = object({{"enum", faces(3)}});
    defs["arrangement"] = typed_plugin(plugins, "arrangement", {"dx", "lower", "upper"});
    defs["integrator"] = typed_plugin(plugins, "integrator");
    defs["integrator"]["dependentSchemas"] =
        object({{"dt", object({{"properties", object({{"courant", false}, {"safety", false}})}})},
                {"courant", object({{"properties", object({{"safety", false}})}})}});
    const Json form = typed_plugin(plugins, "form");
    defs["form"] = object({{"if", string}, {"then", form["properties"]["type"]}, {"else", form}});
    return defs;
}

/// A term with one of these operators.
Json term(const std::map<std::string, Json>& operators) {
    Json any = Json::array(), rules = Json::array();
    for (const auto& [key, schema] : operators) {
        any.push_back(requiring({key}));
        rules.push_back(rule(requiring({key}), schema));
    }
    return object({{"type", "object"}, {"anyOf", any}, {"allOf", rules}});
}

/// A preset's name, or for each variable its rate terms or, for a scalar, the state that gives it.
Json equations_schema(const Plugins& plugins) {
    const Json variable = described(string, "a variable of the equations");
    const Json kernel = object({{"kernel", described(string, "one of /kernels")}});
    const auto derivative = [&](const char* key) {
        Json members = object({{key, variable}, {"form", reference("form")}});
        members.update(kernel);
        members["times"] = described(with(string, "default", "1"), "a product of constants and powers of variables");
        return closed(members, {key, "form"});
    };
    const auto rates = [](const Json& of) { return with(list_of(of), "minItems", 1); };
    const Json of_vector = rates(term({{"gradient", derivative("gradient")},
                                       {"viscosity", named_plugin(plugins, "viscosity", "viscosity", kernel)}}));
    const Json of_scalar = rates(term({{"divergence", derivative("divergence")}}));
    const Json state = named_plugin(plugins, "state", "state", object({{"of", variable}}), {"of"});
    const Json order = described(list_of(list_of(string)), "groups in which splitting integrators advance variables and x");
    const Json assembly = object({{"type", "object"},
                                  {"minProperties", 1},
                                  {"properties", object({{"u", of_vector}, {"U", of_vector}, {"order", order}})},
                                  {"additionalProperties",
                                   object({{"if", object({{"type", "array"}})}, {"then", of_scalar}, {"else", state}})}});
    return object({{"if", string}, {"then", true}, {"else", assembly}});
}

Json medium_schema() {
    const abi::ParameterInfo rows[] = {number("c0", "m/s", positive, "sound speed"),
                                       number("rho0", "kg/m^3", positive, "density at rest")};
    Json members = Json::object();
    add_rows(members, rows);
    return closed(members, {"c0", "rho0"});
}

Json output_schema() {
    const Json point = type_of({"", "m", -infinite, infinite, "", "", {.type = Type::vector}});
    Json members = Json::object();
    members["every"] = value_schema(number("every", "s", 0, "interval of probe samples; 0 is every step", 0));
    members["probes"] = described(list_of(point), "[m] points, each read at the nearest particle");
    return closed(members);
}

Json initial_schema() {
    const Json vector = with(with(list_of(string), "minItems", 1), "maxItems", 3);
    return object({{"type", "object"},
                   {"properties", object({{"u", vector}, {"U", vector}})},
                   {"additionalProperties", string}});
}

Json case_members() {
    const Json kernels = object({{"type", "object"}, {"additionalProperties", reference("kernel")}});
    return object({
        {"title", described(string, "the file's name if not given")},
        {"dimension", object({{"enum", {1, 2, 3}}})},
        {"medium", medium_schema()},
        {"method", reference("method")},
        {"particles", reference("arrangement")},
        {"boundaries", list_of(reference("boundary"))},
        {"kernel", described(reference("kernel"), "of every term that names none")},
        {"kernels", described(kernels, "kernels that terms name")},
        {"equations", described(reference("equations"), "a preset's name, or the assembly")},
        {"viscosity", described(reference("viscosity"), "added to the equation of u")},
        {"sources", list_of(reference("source"))},
        {"initial", described(initial_schema(), "expressions of each variable's values at t = 0")},
        {"integrator", reference("integrator")},
        {"until", value_schema(number("until", "s", positive, "end of the run"))},
        {"reference", described(reference("reference"), "the exact solution that the run is compared with")},
        {"output", output_schema()},
        {"provenance", object({{"description", "what resolved.json carries: plugins, version and ABI"}})},
    });
}

/// Lists with one entry per dimension, and the faces that exist.
Json dimension_rule(int d) {
    const Json fits = object({{"minItems", d}, {"maxItems", d}});
    const auto members = [](const Json& of) { return object({{"properties", of}}); };
    const Json face = members(object({{"face", object({{"enum", faces(d)}})}}));
    return rule(where("dimension", object({{"const", d}})),
                members(object({{"particles", members(object({{"lower", fits}, {"upper", fits}}))},
                                {"boundaries", object({{"items", face}})},
                                {"initial", members(object({{"u", fits}, {"U", fits}}))},
                                {"output", members(object({{"probes", object({{"items", fits}})}}))}})));
}

/// Methods without particles need no kernel and no equations.
Json method_rule(const Plugins& plugins, Registry& registry) {
    Json without = Json::array();
    if (const auto found = plugins.find("method"); found != plugins.end())
        for (const Plugin* plugin : found->second) {
            std::vector<abi::Value> values;
            for (const abi::ParameterInfo& row : plugin->parameters) values.push_back(row.initial);
            if (!registry.create<abi::Method>(*plugin, values)->meshfree()) without.push_back(plugin->name);
        }
    const Json some = object({{"properties", object({{"kernels", object({{"minProperties", 1}})}})}, {"required", Names{"kernels"}}});
    Json needs = requiring({"equations"});
    needs["properties"] = object({{"equations", requiring({"p", "u"})}});
    needs["anyOf"] = Json::array({requiring({"kernel"}), some});
    return object({{"if", where("method", where("type", object({{"enum", without}})))}, {"then", true}, {"else", needs}});
}

Json case_schema(const Plugins& plugins, Registry& registry) {
    Json schema = object({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                          {"title", std::string("A case of sphonic ") + version()}});
    schema.update(closed(case_members(), {"dimension", "medium", "particles", "integrator", "until"}));
    schema["dependentRequired"] = object({{"viscosity", Names{"equations"}}});
    schema["allOf"] = Json::array({dimension_rule(1), dimension_rule(2), dimension_rule(3), method_rule(plugins, registry)});
    schema["$defs"] = kind_schemas(plugins);
    schema["$defs"]["equations"] = equations_schema(plugins);
    return schema;
}

}    // namespace

int schema(const Common& options) {
    Registry registry(Registry::search_path(options.plugin_path));
    Plugins plugins;
    int refused = 0;
    for (const auto& [kind, name] : registry.found()) {
        try {
            plugins[kind].push_back(&registry.find(kind, name, "schema"));
        } catch (const Error& e) {
            log::error(e.what());
            ++refused;
        }
    }
    std::cout << json_text(case_schema(plugins, registry));
    return refused ? int(Fault::plugin) : 0;
}

}    // namespace sphonic::driver
