#pragma once
#include <sphonic/case.hpp>
#include <sphonic/plan.hpp>

namespace sphonic::driver {

/// A case to check or run: one that asks for an accuracy is planned first, and the decisions are logged.
Case load_planned(const std::filesystem::path& file, const std::vector<std::string>& set, Registry& registry);

}    // namespace sphonic::driver
