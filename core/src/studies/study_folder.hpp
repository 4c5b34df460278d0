#pragma once
/// The folder of a study: whose it is, and what it gets at the end.

#include <filesystem>
#include <string>
#include <vector>

#include <sphonic/study.hpp>

namespace sphonic {

/// What each point's runs depend on: its name, the whole case with every default, and the study's threads and cut-off.
/// With `only`, null stands for the other points.
Json identity(const Study& study, Registry& registry, std::optional<std::size_t> only);

/// Where this study and the one of the folder part, in the points that are not null; empty where they agree.
std::string difference(const Study& study, const Json& ours, const std::filesystem::path& folder);

/// points.jsonl, table.csv, table.md and the charts.
void write_tables(const Study& study, const std::vector<StudyResult>& results, const std::filesystem::path& folder);

}    // namespace sphonic
