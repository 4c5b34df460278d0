#pragma once
/// Reading a study file.

#include <sphonic/study.hpp>

#include "section.hpp"

namespace sphonic {

/// A list with entries.
const Json& need_list(Section& section, const std::string& key, const std::string& remedy);
/// A string that is not empty.
std::string need_text(Section& section, const std::string& key, const std::string& remedy);
/// The name of a measure.
std::string read_measure(Section& section, const std::string& key, const std::string& fallback);

/// Gives the points the printed values whose rows name them.
void read_printed(Study& study, Section section);
void read_charts(Study& study, const Json& list);

}    // namespace sphonic
