#pragma once
#include <span>
#include <string>
#include <string_view>

namespace sphonic {

/// The candidate nearest to `name` by edit distance (a transposition counts 1) if close enough to be a typo, else "".
/// Close enough: at most a third of the longer word, at least one edit, and never the whole word.
std::string nearest(std::string_view name, std::span<const std::string> candidates);

}    // namespace sphonic
