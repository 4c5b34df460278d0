#pragma once
#include <optional>
#include <string>

#include <sphonic/simulation.hpp>

#include "particle_media.hpp"

namespace sphonic {

/// Watches a run: everything finite, and no more energy in the set than it had and its sources can have put in. What was
/// seen last while all was well is kept.
class Sentinel {
public:
    Sentinel(const Case& scene, abi::Solver& solver);

    /// Looks at the present state. Nothing while all is well, else when, where and how much.
    std::optional<std::string> look();
    /// Without the reference.
    const Profile& last_good() const { return good_; }

private:
    const Case& scene_;
    abi::Solver& solver_;
    ParticleMedia media_;
    std::vector<double> free_;    ///< 1 where no source sets the field: there energy is what the equations make of it; else 0
    Profile good_;

    Sentinel(const Case& scene, abi::Solver& solver, const abi::Points& points);
    void keep(const abi::Snapshot& shot);
    double energy(const abi::Snapshot& shot) const;
    std::string complaint(const abi::Snapshot& shot, double energy) const;
};

}    // namespace sphonic
