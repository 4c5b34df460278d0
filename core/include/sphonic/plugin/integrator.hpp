#pragma once
/// What an integrator plugin includes: derive from sphonic::abi::Integrator and close the file with SPHONIC_INTEGRATOR("name", Struct, "what it is").

#include <sphonic/plugin/abi/integrator.hpp>
#include <sphonic/plugin/entry.hpp>
#include <sphonic/plugin/math.hpp>

#define SPHONIC_INTEGRATOR(name, Struct, doc) SPHONIC_PLUGIN(sphonic::abi::Integrator, name, Struct, doc)
