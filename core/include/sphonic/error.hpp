#pragma once
#include <stdexcept>
#include <string>

namespace sphonic {

/// What went wrong, as the driver's exit code.
enum class Fault : int { input = 2, diverged = 3, plugin = 4, io = 5 };

/// An error that a user can act on: where, what value, what to do.
class Error : public std::runtime_error {
public:
    /// `place` is a file with a JSON pointer, a plugin file or a command-line option.
    Error(Fault fault, const std::string& place, const std::string& problem, const std::string& remedy = {})
        : std::runtime_error(place + ": " + problem + (remedy.empty() ? "" : ". " + remedy)), fault(fault) {}

    const Fault fault;
};

}    // namespace sphonic
