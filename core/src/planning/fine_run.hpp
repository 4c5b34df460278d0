#pragma once
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <sphonic/simulation.hpp>

#include "moments.hpp"
#include "open_case.hpp"

namespace sphonic {

/// The pressure of a lattice at one time, read anywhere by cubic interpolation. [Pa]
class LatticeField {
public:
    /// A site without a particle (inside a body) is not a number, and so is all that is read next to it.
    LatticeField(const Profile& profile, const abi::Box& box);
    double t() const { return t_; }
    double at(const double x[3]) const;

private:
    double t_;
    abi::Box box_;
    std::vector<double> p_;
};

/// Stands in for an exact solution: a fine run of the scene, in a box so large that nothing comes back from open and absorbing faces, seen at the end and about
/// the other moment. Planned set-ups are interpolated against it.
class FineRun {
public:
    /// Runs ever finer until two in succession, the second at some 0.7 of the first's spacing, differ by less than a tenth of `target`, or by less than half where more would
    /// take more than `most_cpu_s`; else nothing.
    static std::unique_ptr<FineRun> find(const OpenCase& open, double shortest, double target, double most_cpu_s, Registry& registry);

    /// What a run is off by at its end, or near the other moment. Layers that absorb do not count.
    Moment moment(const Profile& run, bool at_end) const;
    /// Its own error: of second order, as much as it differs from the run before.
    double off_by() const { return off_by_; }
    const std::string& name() const { return name_; }    ///< such as "a run of fdtd 4 at dx = 0.01 m"

private:
    std::vector<LatticeField> about_other_, at_end_;
    Profile other_, end_;
    std::string name_;
    double off_by_ = std::numeric_limits<double>::infinity();
    double inner_lower_[3], inner_upper_[3];    ///< between the layers [m]

    FineRun(const OpenCase& open, Simulation& run, const Case& scene, double period, std::string name);
    double value(const std::vector<LatticeField>& fields, double t, const double x[3]) const;
};

}    // namespace sphonic
