#pragma once
#include <memory>

#include <sphonic/case.hpp>

namespace sphonic {

/// The meshfree method on the particles of a case. The case must outlive the solver.
std::unique_ptr<abi::Solver> make_particle_solver(const Case& scene);

}    // namespace sphonic
