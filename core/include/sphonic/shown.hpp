#pragma once
#include <cstdio>
#include <string>

namespace sphonic {

/// A number for people, with so many significant digits.
inline std::string shown(double x, int digits = 4) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, x);
    return text;
}

}    // namespace sphonic
