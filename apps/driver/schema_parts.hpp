#pragma once
/// The JSON Schemas of a case and of a study, in parts.
#include <initializer_list>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <sphonic/json.hpp>
#include <sphonic/plugin/abi/entry.hpp>
#include <sphonic/registry.hpp>

namespace sphonic::driver::schemas {

using Names = std::vector<std::string>;
/// The plugins of each kind, by name.
using Plugins = std::map<std::string, std::vector<const Plugin*>>;

/// A plugin with all its defaults, also those that a case must give: for what no parameter changes.
template <class Interface>
std::unique_ptr<Interface> with_defaults(Registry& registry, const Plugin& plugin) {
    std::vector<abi::Value> values;
    for (const abi::ParameterInfo& row : plugin.parameters) values.push_back(row.initial);
    return registry.create<Interface>(plugin, values);
}

/// Words of the language.
extern const Json string;
Json object(std::initializer_list<std::pair<const char*, Json>> members);
/// An object of these members and no others.
Json closed(const Json& members, const Names& required = {});
Json with(Json schema, const char* key, const Json& value);
Json described(Json schema, const char* text);
Json list_of(const Json& items);
/// One of the schema's definitions, by name.
Json reference(const std::string& name);
Json requiring(const Names& names);
Json rule(const Json& condition, const Json& consequence);
/// An object whose member `key` has this value.
Json where(const std::string& key, const Json& value);

/// Rows of parameter tables: type, range, default, and "[unit] what it is".
Json value_schema(const abi::ParameterInfo& row);
void add_rows(Json& members, std::span<const abi::ParameterInfo> rows);
/// Of a kind's or a part's own keys.
Json rows_of(const std::string& kind);

/// An object in which `key` names a plugin whose parameters stand beside it, and `beside` whatever the plugin is.
Json named_plugin(const Plugins& plugins, const std::string& kind, const std::string& key, const Json& beside, const Names& needed = {});
/// The definition of each kind that stands under "type", with the keys common to it and the rules on them.
Json kind_schemas(const Plugins& plugins, Registry& registry);
/// Members of a kind's plugins that are vectors, each of this schema.
Json vectors_of(const Plugins& plugins, const std::string& kind, const Json& schema);
/// "x_min" ... of so many axes.
Json faces(int dimension);

/// The same schema for cases that say "auto" where a plan may decide. Without /accuracy all these must be given, and `needs` holds too.
Json with_open_places(Json schema, const Json& needs);

/// A preset's name, or the assembly.
Json equations_schema(const Plugins& plugins);

/// Of a study: every key that its reader takes. What looks across objects, as that labels differ, is left to the reader.
Json study_schema();

}    // namespace sphonic::driver::schemas
