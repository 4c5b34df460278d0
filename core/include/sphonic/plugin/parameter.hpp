#pragma once
/// Parameters of a plugin, declared once as a table over the members of its struct.
/// The member's initialiser is the default and is written nowhere else.

#include <array>
#include <limits>
#include <numbers>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <sphonic/plugin/abi/entry.hpp>

namespace sphonic {

inline constexpr double pi = std::numbers::pi;
inline constexpr double infinite = std::numeric_limits<double>::infinity();
/// As a lower bound: greater than zero.
inline constexpr double positive = std::numeric_limits<double>::min();

/// A vector parameter of up to three components; `size` is 0 while it was not given.
struct Vector {
    double v[3] = {0, 0, 0};
    int size = 0;
};

/// One row of the table of struct T.
template <class T>
struct Parameter {
    const char* name;
    const char* unit;
    double lower, upper;
    const char* doc;
    const char* choices;
    std::variant<double T::*, int T::*, bool T::*, std::string T::*, Vector T::*> member;
};

template <class T>
constexpr Parameter<T> real(const char* name, double T::*member, const char* unit, double lower, double upper,
                            const char* doc) {
    return {name, unit, lower, upper, doc, "", member};
}

template <class T>
constexpr Parameter<T> integer(const char* name, int T::*member, int lower, int upper, const char* doc) {
    return {name, "1", double(lower), double(upper), doc, "", member};
}

template <class T>
constexpr Parameter<T> boolean(const char* name, bool T::*member, const char* doc) {
    return {name, "1", 0, 1, doc, "", member};
}

/// `choices` is "a|b|c", or empty for free text.
template <class T>
constexpr Parameter<T> text(const char* name, std::string T::*member, const char* choices, const char* doc) {
    return {name, "1", 0, 0, doc, choices, member};
}

/// A file, written in a case as seen from the case's own folder; the plugin gets the whole path.
template <class T>
constexpr Parameter<T> file(const char* name, std::string T::*member, const char* doc) {
    return {name, abi::file_unit, 0, 0, doc, "", member};
}

template <class T>
constexpr Parameter<T> vector(const char* name, Vector T::*member, const char* unit, double lower, double upper,
                              const char* doc) {
    return {name, unit, lower, upper, doc, "", member};
}

template <class T>
concept HasParameters = requires {
    T::parameters();
};

namespace detail {

inline abi::Value to_value(double x) { return {.type = abi::ParameterType::real, .real = x}; }
inline abi::Value to_value(int x) { return {.type = abi::ParameterType::integer, .integer = x}; }
inline abi::Value to_value(bool x) { return {.type = abi::ParameterType::boolean, .boolean = x}; }
/// Points into `x`.
inline abi::Value to_value(const std::string& x) { return {.type = abi::ParameterType::text, .text = x.c_str()}; }
inline abi::Value to_value(const Vector& x) {
    return {.type = abi::ParameterType::vector, .vector = {x.v[0], x.v[1], x.v[2]}, .size = x.size};
}

inline void from_value(const abi::Value& value, double& x) { x = value.real; }
inline void from_value(const abi::Value& value, int& x) { x = int(value.integer); }
inline void from_value(const abi::Value& value, bool& x) { x = value.boolean; }
inline void from_value(const abi::Value& value, std::string& x) { x = value.text; }
inline void from_value(const abi::Value& value, Vector& x) {
    x = {{value.vector[0], value.vector[1], value.vector[2]}, value.size};
}

/// Kept out of line: inlined, the compiler warns of the variant's alternatives that this T does not have.
template <class T>
[[gnu::noinline]] abi::Value read_member(const T& object, const Parameter<T>& row) {
    return std::visit([&](auto member) { return to_value(object.*member); }, row.member);
}
template <class T>
[[gnu::noinline]] void write_member(T& object, const Parameter<T>& row, const abi::Value& value) {
    std::visit([&](auto member) { from_value(value, object.*member); }, row.member);
}

/// The table of T as plain data; built on first use, kept for the life of the library.
template <class T>
const std::vector<abi::ParameterInfo>& parameter_table() {
    [[maybe_unused]] static const T initial{};
    static const std::vector<abi::ParameterInfo> table = [] {
        std::vector<abi::ParameterInfo> rows;
        if constexpr (HasParameters<T>)
            for (const auto& row : T::parameters())
                rows.push_back(
                    {row.name, row.unit, row.lower, row.upper, row.doc, row.choices, read_member<T>(initial, row)});
        return rows;
    }();
    return table;
}

template <class T>
void set_parameters([[maybe_unused]] T& object, [[maybe_unused]] const abi::Value* values) {
    if constexpr (HasParameters<T>) {
        int i = 0;
        for (const auto& row : T::parameters()) write_member<T>(object, row, values[i++]);
    }
}

}    // namespace detail
}    // namespace sphonic
