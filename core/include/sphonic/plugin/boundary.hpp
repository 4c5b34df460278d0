#pragma once
/// What a boundary plugin includes: derive from sphonic::abi::Boundary and close the file with SPHONIC_BOUNDARY("name", Struct, "what it is").

#include <sphonic/plugin/abi/boundary.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

#define SPHONIC_BOUNDARY(name, Struct, doc) SPHONIC_PLUGIN(sphonic::abi::Boundary, name, Struct, doc)
