#pragma once
/// What a reference plugin includes: derive from sphonic::abi::Reference and close the file with SPHONIC_REFERENCE("name", Struct, "what it is").

#include <sphonic/plugin/abi/reference.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

#define SPHONIC_REFERENCE(name, Struct, doc) SPHONIC_PLUGIN(sphonic::abi::Reference, name, Struct, doc)
