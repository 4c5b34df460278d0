#pragma once
#include <span>
#include <string>

#include <sphonic/json_fwd.hpp>
#include <sphonic/plugin/abi/entry.hpp>

namespace sphonic {

Json to_json(const abi::Value& value);

/// True for a row whose default lies outside its own range: then the key must be given.
bool is_required(const abi::ParameterInfo& row);

/// "h [m] must be greater than 0".
std::string range_sentence(const abi::ParameterInfo& row);
/// "> 0", ">= 0, <= 10", "a|b|c", or nothing.
std::string range_short(const abi::ParameterInfo& row);
const char* type_name(abi::ParameterType type);

/// The keys that the runtime itself reads beside the parameters of every plugin of a kind.
/// Those without a default here are worked out when the case is read.
std::span<const abi::ParameterInfo> common_keys(const std::string& kind);
/// One of them, by name.
const abi::ParameterInfo& common_key(const std::string& kind, const std::string& name);

}    // namespace sphonic
