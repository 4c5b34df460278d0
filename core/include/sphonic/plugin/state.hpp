#pragma once
/// What a state plugin includes: derive from sphonic::abi::State and close the file with SPHONIC_STATE("name", Struct, "what it is").

#include <sphonic/plugin/abi/state.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

#define SPHONIC_STATE(name, Struct, doc) SPHONIC_PLUGIN(sphonic::abi::State, name, Struct, doc)
