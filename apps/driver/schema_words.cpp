#include "schema_parts.hpp"

namespace sphonic::driver::schemas {

const Json string{{"type", "string"}};

Json object(std::initializer_list<std::pair<const char*, Json>> members) {
    Json out = Json::object();
    for (const auto& [name, value] : members) out[name] = value;
    return out;
}

Json closed(const Json& members, const Names& required) {
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

Json where(const std::string& key, const Json& value) {
    Json member = Json::object();
    member[key] = value;
    return object({{"properties", member}, {"required", Names{key}}});
}

}    // namespace sphonic::driver::schemas
