#include <sphonic/parameters.hpp>

#include "schema_parts.hpp"

namespace sphonic::driver::schemas {
namespace {

/// A term with one of these operators.
Json term(const std::map<std::string, Json>& operators) {
    Json any = Json::array(), rules = Json::array();
    for (const auto& [key, schema] : operators) {
        any.push_back(requiring({key}));
        rules.push_back(rule(requiring({key}), schema));
    }
    return object({{"type", "object"}, {"anyOf", any}, {"allOf", rules}});
}

Json variable_names() {
    const Json reserved = object({{"enum", std::vector<std::string>(reserved_names().begin(), reserved_names().end())}});
    return object({{"pattern", "^[A-Za-z_][A-Za-z0-9_]*$"}, {"not", reserved}});
}

}    // namespace

/// For each variable its rate terms or, for a scalar, the state that gives it.
Json equations_schema(const Plugins& plugins) {
    const Json variable = described(string, "a variable of the equations");
    const Json kernel = object({{"kernel", with(described(string, "one of /kernels"), "minLength", 1)}});
    const auto derivative = [&](const char* key) {
        Json members = object({{key, variable}, {"form", reference("form")}});
        members.update(kernel);
        members["times"] = described(with(string, "default", "1"), "a product of constants and powers of variables");
        return closed(members, {key});
    };
    const auto rates = [](const Json& of) { return with(list_of(of), "minItems", 1); };
    Json damped = rows_of("dissipation");
    damped.update(kernel);
    const Json dissipation = named_plugin(plugins, "dissipation", "dissipation", damped);
    const Json of_vector = rates(term({{"gradient", derivative("gradient")},
                                       {"viscosity", named_plugin(plugins, "viscosity", "viscosity", kernel)},
                                       {"dissipation", dissipation}}));
    const Json of_scalar = rates(term({{"divergence", derivative("divergence")}, {"dissipation", dissipation}}));
    const Json state = named_plugin(plugins, "state", "state", object({{"of", variable}}), {"of"});
    const Json groups = list_of(with(list_of(string), "minItems", 1));
    const Json order = described(groups, "groups in which splitting integrators advance variables and x");
    const Json assembly = object({{"type", "object"},
                                  {"minProperties", 1},
                                  {"propertyNames", variable_names()},
                                  {"properties", object({{"u", of_vector}, {"U", of_vector}, {"order", order}})},
                                  {"additionalProperties",
                                   object({{"if", object({{"type", "array"}})}, {"then", of_scalar}, {"else", state}})}});
    return object({{"if", string}, {"then", true}, {"else", assembly}});
}

}    // namespace sphonic::driver::schemas
