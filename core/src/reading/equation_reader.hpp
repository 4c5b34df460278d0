#pragma once
/// The parts of reading equations.

#include "case_reader.hpp"

namespace sphonic {

/// The content of /equations; the first pass names the variables, the second fills in what refers to them.
void read_assembly(Case& scene, Section& section, Registry& registry);
/// The case's viscosity as a term of u; `section` resolved.
Json append_viscosity(Case& scene, Section section, Registry& registry);
/// The groups that splitting integrators advance in turn, and the one of the positions.
void read_order(Equations& equations, Section& section);

}    // namespace sphonic
