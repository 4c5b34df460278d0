/// The JSON Schemas of a study and of a case: this one made from the tables that also make parsing, range errors and `describe`.
/// It holds every rule that looks at one object; what looks across objects (a kernel's reach, regions, the step) is
/// left to `check`.
#include <iostream>

#include <sphonic/parameters.hpp>
#include <sphonic/plugin/abi/method.hpp>
#include <sphonic/version.hpp>

#include "commands.hpp"
#include "found_plugins.hpp"
#include "schema_parts.hpp"

namespace sphonic::driver {
namespace {

using namespace schemas;

Json output_schema() {
    Json members = rows_of("output");
    const Json point = with(with(list_of(object({{"type", "number"}})), "minItems", 1), "maxItems", 3);
    members["probes"] = described(list_of(point), "[m] points in the box, each read at the nearest particle");
    return closed(members);
}

/// One medium, or a list whose first fills the box.
Json medium_schema() {
    Json whole = rows_of("medium");
    for (const char* of_others : {"region", "dx"}) whole.erase(of_others);
    Json list = list_of(closed(rows_of("medium"), {"c0", "rho0", "region"}));
    list["prefixItems"] = Json::array({closed(whole, {"c0", "rho0"})});
    list["minItems"] = 1;
    return object({{"anyOf", Json::array({closed(whole, {"c0", "rho0"}), list})}});
}

Json initial_schema() {
    const Json vector = with(with(list_of(string), "minItems", 1), "maxItems", 3);
    return object({{"type", "object"},
                   {"properties", object({{"u", vector}, {"U", vector}})},
                   {"additionalProperties", string}});
}

Json case_members() {
    const Json kernels = object({{"type", "object"},
                                 {"propertyNames", object({{"minLength", 1}})},
                                 {"additionalProperties", reference("kernel")}});
    Json members = object({
        {"$schema", described(string, "where editors find this schema")},
        {"accuracy", described(closed(object({{"target", object({{"type", "number"}, {"minimum", 1e-6}, {"exclusiveMaximum", 1}})}}), {"target"}),
                               "what `run` plans the case to first: the relative L2 error of p to stay below")},
        {"title", with(described(string, "the file's name if not given"), "minLength", 1)},
        {"dimension", object({{"enum", {1, 2, 3}}})},
        {"medium", medium_schema()},
        {"method", reference("method")},
        {"particles", reference("arrangement")},
        {"boundaries", list_of(reference("boundary"))},
        {"obstacles", described(list_of(reference("shape")), "bodies cut out of a set that does not move, with walls")},
        {"kernel", described(reference("kernel"), "of every term that names none")},
        {"kernels", described(kernels, "kernels that terms name")},
        {"equations", described(reference("equations"), "a preset's name, or the assembly")},
        {"viscosity", described(reference("viscosity"), "added to the equation of u")},
        {"dissipation", described(reference("dissipation"), "added to the equations of p and u")},
        {"sources", list_of(reference("source"))},
        {"initial", described(initial_schema(), "expressions of each variable's values at t = 0")},
        {"integrator", reference("integrator")},
        {"reference", described(reference("reference"), "the exact solution that the run is compared with")},
        {"output", output_schema()},
        {"provenance", object({{"type", "object"}, {"description", "what resolved.json carries: plugins, version and ABI"}})},
    });
    members.update(rows_of("case"));
    return members;
}

/// Lists with one entry per dimension, and the faces that exist.
Json dimension_rule(const Plugins& plugins, int d) {
    const Json fits = object({{"minItems", d}, {"maxItems", d}});
    const auto members = [](const Json& of) { return object({{"properties", of}}); };
    Json particles = vectors_of(plugins, "arrangement", fits);
    particles.update(object({{"lower", fits}, {"upper", fits}}));
    const Json face = members(object({{"face", object({{"enum", faces(d)}})}}));
    return rule(where("dimension", object({{"const", d}})),
                members(object({{"particles", members(particles)},
                                {"boundaries", object({{"items", face}})},
                                {"obstacles", object({{"items", members(vectors_of(plugins, "shape", fits))}})},
                                {"sources", object({{"items", members(vectors_of(plugins, "source", fits))}})},
                                {"reference", members(vectors_of(plugins, "reference", fits))},
                                {"initial", members(object({{"u", fits}, {"U", fits}}))},
                                {"output", members(object({{"probes", object({{"items", fits}})}}))}})));
}

/// Methods without particles need no kernel and no equations, and some know no obstacles.
Json method_rule(const Plugins& plugins, Registry& registry) {
    Json without = Json::array(), bodiless = Json::array();
    if (const auto found = plugins.find("method"); found != plugins.end())
        for (const Plugin* plugin : found->second) {
            const auto method = with_defaults<abi::Method>(registry, *plugin);
            if (!method->meshfree()) without.push_back(plugin->name);
            if (!method->bodies()) bodiless.push_back(plugin->name);
        }
    const Json some = object({{"properties", object({{"kernels", object({{"minProperties", 1}})}})}, {"required", Names{"kernels"}}});
    Json needs = requiring({"equations"});
    needs["properties"] = object({{"equations", requiring({"p", "u"})}});
    needs["anyOf"] = Json::array({requiring({"kernel"}), some});
    const Json open = object({{"properties", object({{"obstacles", object({{"maxItems", 0}})}})}});
    const auto one_of = [](const Json& names) { return where("method", where("type", object({{"enum", names}}))); };
    return object({{"if", one_of(without)}, {"then", object({{"if", one_of(bodiless)}, {"then", open}})}, {"else", needs}});
}

Json case_schema(const Plugins& plugins, Registry& registry) {
    Json schema = closed(case_members(), {"dimension", "medium", "particles", "integrator", "until"});
    schema["allOf"] = Json::array();
    for (int d = 1; d <= 3; ++d) schema["allOf"].push_back(dimension_rule(plugins, d));
    schema["$defs"] = kind_schemas(plugins, registry);
    schema["$defs"]["equations"] = equations_schema(plugins);
    Json needs = method_rule(plugins, registry);
    needs["dependentRequired"] = object({{"viscosity", Names{"equations"}}, {"dissipation", Names{"equations"}}});
    return with_open_places(std::move(schema), needs);
}

void print(const std::string& what, const Json& of_it) {
    Json schema = object({{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "A " + what + " of sphonic " + version()}});
    schema.update(of_it);
    std::cout << json_text(schema);
}

}    // namespace

int schema(const Common& options, const std::string& what) {
    if (what == "study") return print(what, study_schema()), 0;
    Registry registry(Registry::search_path(options.plugin_path));
    const FoundPlugins found = load_found(registry, "schema");
    Plugins plugins;
    for (const Plugin* plugin : found.plugins) plugins[plugin->kind].push_back(plugin);
    print(what, case_schema(plugins, registry));
    return found.exit_code();
}

}    // namespace sphonic::driver
