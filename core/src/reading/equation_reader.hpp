#pragma once
/// The parts of reading equations.

#include "case_reader.hpp"

namespace sphonic {

/// The content of /equations; the first pass names the variables, the second fills in what refers to them.
void read_assembly(Case& scene, Section& section, Registry& registry);
/// The case's viscosity as a term of u; `section` resolved.
Json append_viscosity(Case& scene, Section section, Registry& registry);
/// The plugin named by `key` as a term of a variable, its strength by the plugin's law for the set's disorder if not given.
Term read_dissipation(Case& scene, Section& section, Registry& registry, const std::string& key, int variable, int kernel);
/// The case's dissipation as terms of p, or what it is computed from, and u; `section` resolved.
Json append_dissipation(Case& scene, Section section, Registry& registry);
/// Refuses dissipation of other variables, and with what only a stencil does.
void check_dissipation(const Case& scene, const Section& root);
/// The groups that splitting integrators advance in turn, and the one of the positions.
void read_order(Equations& equations, Section& section);

}    // namespace sphonic
