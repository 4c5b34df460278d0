#pragma once
#include <span>
#include <string>
#include <vector>

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
/// The same of the parts of a case that are no plugins: "case", "medium" and "output".
/// Those without a default here are worked out when the case is read.
std::span<const abi::ParameterInfo> common_keys(const std::string& kind);
/// One of them, by name.
const abi::ParameterInfo& common_key(const std::string& kind, const std::string& name);

/// Which common keys of a kind stand together. The reader and the schema both go by this.
struct KeyRule {
    enum class How {
        required,              ///< each of them
        required_to_impose,    ///< each of them, of a source whose action sets values
        exactly_one,
        at_most_one,
    } how;
    std::vector<std::string> keys;
    const char* what;      ///< they give, for the message that none does
    const char* remedy;    ///< empty: made from the key's row
};
std::span<const KeyRule> key_rules(const std::string& kind);

/// Where a case may say "auto" for `plan` to decide, as JSON pointers; "*" is each member of a list.
std::span<const std::string> planned_places();

/// Names that expressions give a meaning of their own: no variable can have them.
std::span<const std::string> reserved_names();

/// The shortest text of a number: "1e-05", "3", not "3.0".
std::string number_text(double x);

}    // namespace sphonic
