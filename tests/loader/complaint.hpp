#pragma once
/// Tests of messages: what an action says when it refuses.

#include <ostream>
#include <string>

#include <catch2/catch.hpp>
#include <sphonic/error.hpp>

namespace sphonic {

inline std::ostream& operator<<(std::ostream& out, Fault fault) { return out << "exit code " << int(fault); }

/// The message with which `action` fails, which must be of category `fault`.
template <class Action>
std::string complaint(Fault fault, Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        CHECK(error.fault == fault);
        return error.what();
    }
    FAIL("nothing was refused");
    return {};
}

}    // namespace sphonic
