#pragma once
#include <string>

#include <sphonic/expression.hpp>

namespace sphonic {

/// The text, a condition or a number, in muParser's notation; an Error at `place` if it is not one.
std::string muparser_code(const std::string& text, const Expression::Constants& constants, int dimension,
                          const std::string& place, bool condition);

}    // namespace sphonic
