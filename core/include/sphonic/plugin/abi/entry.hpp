#pragma once
/// The door between the runtime and a plugin library: one C function returns static plain data.
/// Everything in plugin/abi/ enters the ABI tag, so changing a line here makes older plugins refuse to load.

#include <cstddef>
#include <cstdint>

namespace sphonic::abi {

inline constexpr char magic[8] = {'s', 'p', 'h', 'o', 'n', 'i', 'c', '1'};

/// Name of the one exported function of a plugin library.
inline constexpr const char* entry_symbol = "sphonic_plugin_entry";

enum class ParameterType : int { real, integer, boolean, text, vector };

/// One parameter value; only the member that `type` names is meaningful.
struct Value {
    ParameterType type = ParameterType::real;
    double real = 0;
    std::int64_t integer = 0;
    bool boolean = false;
    const char* text = nullptr;
    double vector[3] = {0, 0, 0};
    int size = 0;    ///< components of `vector`; 0 means "not given"
};

/// Unit of a text parameter that is a file's path, seen from the folder of the case.
inline constexpr const char* file_unit = "file";

/// One row of a plugin's parameter table, from which parsing, range errors, `describe` and the documents are made.
struct ParameterInfo {
    const char* name;
    const char* unit;       ///< "1" for a pure number or a text
    double lower, upper;    ///< inclusive; `positive` as the lower bound means "> 0"
    const char* doc;
    const char* choices;    ///< "a|b|c" for a text parameter with a closed set, else empty
    Value initial;          ///< the default; its `type` is the parameter's type
};

/// What the entry function returns.
struct Entry {
    char magic[8];
    std::uint64_t size;    ///< sizeof(Entry) as the plugin saw it
    const char* abi;       ///< ABI tag as the plugin saw it
    const char* kind;
    const char* name;
    const char* doc;
    const ParameterInfo* parameters;
    int parameter_count;
    /// One value per table row; returns the kind's interface, owned by the caller.
    void* (*create)(const Value* values);
};

using EntryFunction = const Entry* (*)();

}    // namespace sphonic::abi
