#pragma once
/// What a shape plugin includes: derive from sphonic::abi::Shape and close the file with SPHONIC_SHAPE("name", Struct, "what it is").

#include <sphonic/plugin/abi/shape.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

#define SPHONIC_SHAPE(name, Struct, doc) SPHONIC_PLUGIN(sphonic::abi::Shape, name, Struct, doc)
