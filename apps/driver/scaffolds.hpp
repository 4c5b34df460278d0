#pragma once
#include <optional>
#include <string>

namespace sphonic::driver {

/// The source of a new plugin, and the --set that puts it into a case of the repository.
struct Scaffold {
    std::string source, set, scene;
};

/// Nothing for a kind that has no scaffold. `name` is lower_snake_case.
std::optional<Scaffold> scaffold(const std::string& kind, const std::string& name);

}    // namespace sphonic::driver
