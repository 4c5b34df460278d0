#pragma once
#include <optional>
#include <string>

#include <sphonic/simulation.hpp>

#include "particle_media.hpp"

namespace sphonic {

/// Watches a run: everything finite, and no more energy in the set than it had and its sources can have put in. It looks at all of
/// it, and more often at the pressure of some of the particles, so often that each takes a hundredth of the time of the steps, and
/// at all of it after every step where the energy is above what it should be.
/// What was seen last while all was well is kept.
class Sentinel {
public:
    /// Of a solver at its start, whose steps are dt [s].
    Sentinel(const Case& scene, abi::Solver& solver, double dt);

    /// To be asked after every step: true if it is time to look.
    bool due() { return --steps_left_ <= 0 || (--glance_left_ <= 0 && alarmed()); }
    /// Looks at the present state. Nothing while all is well, nor in the first few steps after, in which growth is measured; then
    /// when it began, where, how much and how fast. At the `end` of a run at once.
    std::optional<std::string> look(bool end = false);
    /// Tells how long a step takes on average [s].
    void pace(double step_s);
    /// Without the reference.
    const Profile& last_good() const { return good_; }

private:
    /// A look at the energy [J/m^(3-d)].
    struct Seen {
        double t = 0, energy = 0;
    };

    const Case& scene_;
    abi::Solver& solver_;
    double dt_;
    ParticleMedia media_;
    std::vector<double> free_;    ///< 1 where no source sets the field: there energy is what the equations make of it; else 0
    Profile good_;
    Seen from_, to_;              ///< what growth is measured between: the last look while all was well, or the first after it, and the last
    std::string onset_;           ///< what was seen first when all was no longer well
    int steps_after_ = 0;
    double look_s_ = 1, glance_s_ = 1;    ///< what each takes, where nothing interrupts it
    long steps_left_ = 1, between_ = 1, glance_left_ = 1, glance_between_ = 1;
    long sampled_ = 0;    ///< particles that a glance is at
    double offset_ = 0;   ///< of a glance's particles, in units of their distance
    double alarm_;                 ///< energy by a glance over what is accounted for, above which all is looked at

    Sentinel(const Case& scene, abi::Solver& solver, double dt, const abi::Snapshot& shot);
    void choose_samples(long n);
    bool alarmed();
    void keep(const abi::Snapshot& shot);
    double energy(const abi::Snapshot& shot) const;
    std::string place(const abi::Snapshot& shot, double energy) const;
    std::string growth() const;
};

}    // namespace sphonic
