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

/// True or false; false where it is missing.
bool read_flag(Section& section, const std::string& key);
/// One measure, or several: the first is the study's.
void read_measures(Study& study, Section& section);
int read_repeat(Section& section);
/// A positive number, which is a member or stands in one.
double positive(const Section& section, const std::string& key, const Json& value, const std::string& remedy);
/// Of relative errors 1 % and 0.1 % unless given.
void read_targets(Study& study, Section& section);

/// The dimension whose worst point counts, if any.
void read_worst_over(Study& study, Section& section);

/// Gives the points the printed values whose rows name them.
void read_printed(Study& study, Section section);
void read_charts(Study& study, const Json& list);

}    // namespace sphonic
