#pragma once
#include <algorithm>
#include <vector>

#include <sphonic/case.hpp>
#include <sphonic/plugin/abi/integrator.hpp>

#include "tier.hpp"

namespace sphonic {

/// Steps of a run, the largest frequency [1/s] of the set, and by how much errors grow in the run.
struct StepFacts {
    double dt;
    long count;
    double frequency, growth;
};

/// What a group stands for: variables, and whether positions go along.
struct GroupParts {
    std::vector<int> variables;
    std::vector<int> components;
    bool positions = false;
    bool reads_itself = true;    ///< a term reads what the group advances: the rate needs an array of its own

    GroupParts() = default;
    GroupParts(const Case& scene, const Components& of, std::vector<int> variables, bool positions);
    bool has(int variable) const { return std::ranges::find(variables, variable) != variables.end(); }

    /// By splitting group, then everything, fields, positions.
    static std::vector<GroupParts> all(const Case& scene, const Components& of);
    /// Of a group in `all`, where `splitting` groups come first.
    static std::size_t number(abi::Group group, int splitting) { return std::size_t(group >= 0 ? group : splitting - 1 - group); }

private:
    bool reads(const Case& scene) const;
};

}    // namespace sphonic
