#pragma once
/// What a method plugin includes: derive from sphonic::abi::Method and close the file with SPHONIC_METHOD("name", Struct, "what it is").

#include <sphonic/plugin/abi/method.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

#define SPHONIC_METHOD(name, Struct, doc) SPHONIC_PLUGIN(sphonic::abi::Method, name, Struct, doc)
