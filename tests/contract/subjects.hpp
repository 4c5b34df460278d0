#pragma once
/// What the laws run over: every plugin of a kind on the search path, third-party ones in SPHONIC_PLUGIN_PATH too.

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <sphonic/plugin/parameter.hpp>
#include <sphonic/registry.hpp>

namespace sphonic::contract {

/// One plugin with one set of parameter values. Each parameter is at its default, or one of them is at an end of its
/// range: a plugin answers for all that it lets a case ask for.
template <class Interface>
struct Subject {
    std::string label;    ///< such as "gaussian" or "gaussian with renormalise = true"
    bool defaults;
    std::unique_ptr<Interface> object;
};

inline Registry& registry() {
    static Registry found{Registry::search_path()};
    return found;
}

/// The default; a value within the range for a parameter that has no default.
inline abi::Value usual(const abi::ParameterInfo& row) {
    abi::Value value = row.initial;
    const auto inside = [&](double x) {
        if (x < row.lower && row.lower == positive) return std::min(1.0, row.upper);
        return std::clamp(x, row.lower, row.upper);
    };
    if (value.type == abi::ParameterType::real) value.real = inside(value.real);
    if (value.type == abi::ParameterType::integer) value.integer = std::int64_t(inside(double(value.integer)));
    return value;
}

inline std::vector<abi::Value> usual(const Plugin& plugin) {
    std::vector<abi::Value> values;
    for (const auto& row : plugin.parameters) values.push_back(usual(row));
    return values;
}

struct Variation {
    std::size_t row;
    std::string text;
    abi::Value value;
};

/// Every parameter at each end of its range, as far as it has one, and at each of its choices.
/// Texts of the values point into `storage`.
inline std::vector<Variation> variations(const Plugin& plugin, std::vector<std::unique_ptr<std::string>>& storage) {
    std::vector<Variation> all;
    for (std::size_t i = 0; i < plugin.parameters.size(); ++i) {
        const abi::ParameterInfo& row = plugin.parameters[i];
        const auto add = [&](const auto& text, const abi::Value& value) {
            std::ostringstream out;
            out << std::boolalpha << " with " << row.name << " = " << text;
            all.push_back({i, out.str(), value});
        };
        for (const double end : {row.lower, row.upper}) {
            if (!std::isfinite(end) || end == positive) continue;
            if (row.initial.type == abi::ParameterType::real) add(end, {.type = abi::ParameterType::real, .real = end});
            if (row.initial.type == abi::ParameterType::integer)
                add(end, {.type = abi::ParameterType::integer, .integer = std::int64_t(end)});
        }
        if (row.initial.type == abi::ParameterType::boolean)
            add(!row.initial.boolean, {.type = abi::ParameterType::boolean, .boolean = !row.initial.boolean});
        if (row.initial.type == abi::ParameterType::text && row.choices[0]) {
            std::istringstream choices(row.choices);
            for (std::string choice; std::getline(choices, choice, '|');) {
                storage.push_back(std::make_unique<std::string>(choice));
                add(choice, {.type = abi::ParameterType::text, .text = storage.back()->c_str()});
            }
        }
    }
    return all;
}

template <class Interface>
std::unique_ptr<Interface> make(const std::string& name) {
    const Plugin& plugin = registry().find(Interface::kind, name, "contract");
    return registry().create<Interface>(plugin, usual(plugin));
}

/// All subjects of a kind. A plugin that does not load or cannot be created is a failure of its own.
template <class Interface>
std::vector<Subject<Interface>> subjects() {
    std::vector<Subject<Interface>> all;
    std::vector<std::unique_ptr<std::string>> storage;
    for (const std::string& name : registry().names(Interface::kind)) {
        try {
            const Plugin& plugin = registry().find(Interface::kind, name, "contract");
            all.push_back({name, true, registry().create<Interface>(plugin, usual(plugin))});
            for (const Variation& variation : variations(plugin, storage)) {
                auto values = usual(plugin);
                values[variation.row] = variation.value;
                all.push_back({name + variation.text, false, registry().create<Interface>(plugin, values)});
            }
        } catch (const std::exception& e) {
            FAIL_CHECK(e.what());
        }
    }
    REQUIRE_FALSE(all.empty());
    return all;
}

/// Stands behind the end of an output block, where nothing may be written.
inline constexpr double untouched = 42;

/// The largest absolute difference of two equally long lists; NaN if one of them is.
inline double gap(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double difference = std::abs(a[k] - b[k]);
        if (std::isnan(difference)) return difference;
        largest = std::max(largest, difference);
    }
    return largest;
}

inline double largest(const std::vector<double>& a) { return gap(a, std::vector<double>(a.size(), 0)); }

}    // namespace sphonic::contract
