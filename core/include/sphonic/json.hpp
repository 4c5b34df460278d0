#pragma once
#include <nlohmann/json.hpp>


#include <filesystem>
#include <string>
#include <string_view>

namespace sphonic {

/// Members keep the order of the file.
using Json = nlohmann::ordered_json;

/// Strict JSON. Refused: duplicate keys, numbers a double cannot hold (1e999, 1e-999), NaN, more than 64 nested
/// values, a byte-order mark, text after the value, empty text. Errors stand at `FILE: /json/pointer` (`/` is the
/// root), syntax errors at `FILE:LINE:COLUMN` (columns count bytes).
Json parse_json(std::string_view text, const std::string& file);

/// Fault::input where there is no such file, Fault::io where it cannot be read.
Json read_json(const std::filesystem::path& file);

/// Applies `/pointer=value`: the value is strict JSON, or else a string. Splits at the first `=`.
void set_at(Json& root, const std::string& assignment);

/// Sets the value at a JSON pointer and creates missing objects on the way. In an array an index replaces; the index
/// one past the end, or `-`, appends. On an error `root` is unchanged.
void set_at(Json& root, const std::string& pointer, const Json& value, const std::string& place);

/// Indented JSON text ending in a newline. Numbers read back to the same double, with the fewest digits but for about
/// 1 in 1000. A non-finite number is written as null, a byte that is not UTF-8 as U+FFFD.
std::string json_text(const Json& value);

}    // namespace sphonic
