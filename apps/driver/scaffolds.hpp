#pragma once
#include <optional>
#include <string>

namespace sphonic::driver {

/// The source of a new plugin, and the --set that puts it into cases/li2015/propagation.json.
struct Scaffold {
    std::string source, set;
};

/// Nothing for a kind that has no scaffold. `name` is lower_snake_case.
std::optional<Scaffold> scaffold(const std::string& kind, const std::string& name);

}    // namespace sphonic::driver
