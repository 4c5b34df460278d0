#include "expression_names.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>

#include <sphonic/error.hpp>
#include <sphonic/nearest.hpp>

namespace sphonic {
namespace {

constexpr Words one_argument = " sin cos tan exp sqrt abs log ", more_arguments = " min max ";
constexpr Words coordinates = " x y z ";

bool is_function(std::string_view name) { return among(one_argument, name) || among(more_arguments, name); }

}    // namespace

Names::Names(const SourceText& source, const Expression::Constants& constants, int dimension)
    : source_(source), constants_(constants.values), dimension_(dimension) {
    assert(dimension >= 1 && dimension <= 3);
    known_.assign({"x", "y", "z"});
    known_.resize(static_cast<std::size_t>(dimension));
    known_.insert(known_.end(), {"r", "pi"});
    std::istringstream functions(std::string(one_argument) + std::string(more_arguments));
    known_.insert(known_.end(), std::istream_iterator<std::string>(functions), {});
    for (const auto& [name, value] : constants_) add_constant(name, value);
    constants_.emplace_back("pi", std::numbers::pi);
}

std::string Names::value(const std::string& name) const {
    for (const auto& [constant, value] : constants_)
        if (name == constant) {
            std::array<char, 32> digits;
            return "(" + std::string(digits.data(), std::to_chars(digits.begin(), digits.end(), value).ptr) + ")";
        }
    if (!is_known(name) || is_function(name))
        refuse(name, is_function(name) ? " has no arguments" : "", "Write them in parentheses");
    return name;
}

void Names::require_function(const std::string& name) const {
    if (!is_function(name)) refuse(name, is_known(name) ? " is not a function" : "", "Write * to multiply");
}

void Names::require_arguments(const std::string& function, std::size_t count) const {
    const bool one = among(one_argument, function);
    if (one ? count != 1 : count < 2)
        source_.refuse(function + " is given " + std::to_string(count) + (count == 1 ? " argument" : " arguments"),
                       one ? "Give one" : "Give two or more");
}

bool Names::is_known(const std::string& name) const { return std::count(known_.begin(), known_.end(), name) > 0; }

void Names::add_constant(const std::string& name, double value) {
    const std::string constant = "the constant " + in_quotes(name);
    const bool is_name = !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), in_name);
    if (!is_name || among(joiners, name) || among(coordinates, name) || is_known(name))
        throw Error(Fault::input, source_.place, constant + " has a name that is taken or is no name", "Rename it");
    if (!std::isfinite(value))
        throw Error(Fault::input, source_.place, constant + " is not finite", "Give it a finite value");
    known_.push_back(name);
}

void Names::refuse(const std::string& name, const std::string& misuse, const std::string& remedy) const {
    if (!misuse.empty()) source_.refuse(in_quotes(name) + misuse, remedy);
    if (among(coordinates, name))
        source_.refuse(in_quotes(name) + " does not exist in " + std::to_string(dimension_) + "-D",
                       dimension_ == 1 ? "Use x or r" : "Use x, y or r");
    std::string list;
    for (const std::string& other : known_) list += (list.empty() ? "" : ", ") + other;
    const std::string guess = nearest(name, known_);
    source_.refuse(in_quotes(name) + " is unknown",
                   guess.empty() ? "Known are " + list : "Did you mean " + in_quotes(guess) + "?");
}

}    // namespace sphonic
