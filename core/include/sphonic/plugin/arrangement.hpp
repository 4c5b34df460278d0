#pragma once
/// What an arrangement plugin includes: derive from sphonic::abi::Arrangement and close the file with SPHONIC_ARRANGEMENT("name", Struct, "what it is").

#include <sphonic/plugin/abi/arrangement.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

#define SPHONIC_ARRANGEMENT(name, Struct, doc) SPHONIC_PLUGIN(sphonic::abi::Arrangement, name, Struct, doc)
