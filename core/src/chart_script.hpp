#pragma once
#include <filesystem>
#include <string>

#include "sphonic/chart.hpp"

namespace sphonic::charting {

/// A complete gnuplot script, data inside, that writes the picture to both files.
std::string script(const Chart& chart, const std::filesystem::path& png, const std::filesystem::path& svg);

}    // namespace sphonic::charting
