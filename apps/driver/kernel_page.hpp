#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <sphonic/kernel_card.hpp>
#include <sphonic/shown.hpp>

namespace sphonic::driver {

using Ranking = std::vector<std::pair<std::string, KernelRow>>;

/// The card as one HTML file without links outside: tables, and the chart that stands in `svg`, if it was drawn.
std::string kernel_page(const KernelCard& card, const Ranking& ranking, const std::filesystem::path& svg);

using sphonic::shown;
/// "none" where there is none.
std::string shown(const std::optional<double>& x);

}    // namespace sphonic::driver
