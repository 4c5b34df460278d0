#pragma once
#include <string>

/// Messages for people, on stderr. Results never come this way.
namespace sphonic::log {

void info(const std::string& message);
void warn(const std::string& message);
void error(const std::string& message);

}    // namespace sphonic::log
