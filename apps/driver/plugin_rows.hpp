#pragma once
#include <string>

#include <sphonic/json_fwd.hpp>
#include <sphonic/registry.hpp>

namespace sphonic::driver {

/// What `list` and `describe` say of a plugin with --json.
Json plugin_json(const Plugin& plugin);

/// The default as JSON; "required", or empty, where there is none.
std::string shown_default(const abi::ParameterInfo& row);
/// The same for a key that every plugin of the kind has.
std::string shown_default(const abi::ParameterInfo& row, const std::string& kind);

/// A section of GitHub Markdown per kind: its plugins with their parameters, then the keys of all of them.
std::string plugins_markdown(const std::vector<const Plugin*>& plugins);

}    // namespace sphonic::driver
