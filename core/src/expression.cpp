#include <sphonic/expression.hpp>

#include <sphonic/error.hpp>
#include <sphonic/nearest.hpp>

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

namespace sphonic {
namespace {

using Constants = Expression::Constants;
using Words = std::vector<std::string>;

const Words one_argument{"sin", "cos", "tan", "exp", "sqrt", "abs", "log"};
