#pragma once
/// For headers that name Json without using it: the whole of nlohmann's header costs seconds.
#include <nlohmann/json_fwd.hpp>

namespace sphonic {

using Json = nlohmann::ordered_json;

}    // namespace sphonic
