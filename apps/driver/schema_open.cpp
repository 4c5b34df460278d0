#include <algorithm>
#include <map>
#include <sstream>

#include <sphonic/parameters.hpp>

#include "schema_parts.hpp"

namespace sphonic::driver::schemas {
namespace {

const Json planned = object({{"const", "auto"}});

Names parts_of(const std::string& pointer) {
    Names parts;
    std::istringstream stream(pointer.substr(1));
    for (std::string part; std::getline(stream, part, '/');) parts.push_back(part);
    return parts;
}

Json or_auto(const Json& schema) { return object({{"if", planned}, {"then", true}, {"else", schema}}); }

void drop_name(Json& names, const std::string& name) {
    Json kept = Json::array();
    for (const Json& one : names)
        if (one != name) kept.push_back(one);
    names = kept;
}

/// A number, or "auto": what holds for numbers says nothing of texts.
void open_number(Json& member) {
    member["type"] = Names{member["type"], "string"};
    member["pattern"] = "^auto$";
}

/// A member of every plugin of a kind that has it.
void open_member(Json& definition, const std::string& kind, const std::string& key) {
    if (key == "type") {
        drop_name(definition["required"], key);
        definition["properties"][key]["enum"].push_back("auto");
        Json members = rows_of(kind);
        members[key] = planned;
        const Json none = object({{"not", requiring({key})}}), any = object({{"anyOf", Json::array({none, where(key, planned)})}});
        definition["allOf"].push_back(rule(any, closed(members)));
        return;
    }
    for (Json& plugin : definition["allOf"]) {
        Json& body = plugin["then"];
        if (!body.contains("properties") || !body["properties"].contains(key)) continue;
        open_number(body["properties"][key]);
        if (body.contains("required")) drop_name(body["required"], key);
    }
}

/// A member is there, if it must be, and is not "auto".
Json given(const Names& parts, std::size_t from, bool needed) {
    if (from == parts.size()) return object({{"not", planned}});
    if (parts[from] == "*") return object({{"items", given(parts, from + 1, needed)}});
    Json member = Json::object(), out;
    member[parts[from]] = given(parts, from + 1, needed);
    out = object({{"properties", member}});
    if (needed && from + 1 == parts.size()) out["required"] = Names{parts[from]};
    return out;
}

}    // namespace

Json with_open_places(Json schema, const Json& needs) {
    const std::map<std::string, std::string> kinds{{"integrator", "integrator"}, {"particles", "arrangement"}, {"boundaries", "boundary"}};
    const Names needed{"/integrator", "/integrator/type", "/particles/dx"};
    Json rules = Json::array({needs});
    for (const std::string& place : planned_places()) {
        const Names parts = parts_of(place);
        if (parts.size() == 1) {
            Json& member = schema["properties"][parts[0]];
            member = or_auto(member);
            drop_name(schema["required"], parts[0]);
        } else if (parts[0] == "medium") {
            open_number(schema["properties"]["medium"]["anyOf"][1]["items"]["properties"][parts.back()]);    // of the list
        } else {
            open_member(schema["$defs"][kinds.at(parts[0])], kinds.at(parts[0]), parts.back());
        }
        rules.push_back(given(parts, 0, std::ranges::find(needed, place) != needed.end()));
    }
    schema["allOf"].push_back(object({{"if", requiring({"accuracy"})}, {"then", true}, {"else", object({{"allOf", rules}})}}));
    return schema;
}

}    // namespace sphonic::driver::schemas
