#pragma once
#include <filesystem>

#include <sphonic/study.hpp>

namespace sphonic::driver {

/// report.html in the study's folder: its charts, what each target costs, the ranked table and its CSV in one file, with an interactive
/// chart where the scripts that draw it are installed.
void write_study_page(const Study& study, const std::vector<StudyResult>& results, const std::filesystem::path& folder);

}    // namespace sphonic::driver
