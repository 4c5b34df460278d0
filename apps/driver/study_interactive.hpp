#pragma once
#include <string>

#include <sphonic/study.hpp>

namespace sphonic::driver {

/// The part of a page that draws error against CPU time by Vega-Lite, with all scripts and data inside: families to hide, norms to
/// choose, and each point's whole configuration under the pointer. Empty where the scripts are not installed.
std::string interactive_chart(const Study& study, const std::vector<StudyResult>& results);

}    // namespace sphonic::driver
