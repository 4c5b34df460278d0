#pragma once
/// What a source plugin includes: derive from sphonic::abi::Source and close the file with SPHONIC_SOURCE("name", Struct, "what it is").

#include <sphonic/plugin/abi/source.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

#define SPHONIC_SOURCE(name, Struct, doc) SPHONIC_PLUGIN(sphonic::abi::Source, name, Struct, doc)
