#pragma once
#include <cstddef>
#include <vector>

#include <sphonic/case.hpp>

#include "particle_media.hpp"
#include "store.hpp"

namespace sphonic {

/// The particles that one source acts on, with room for its values there.
class SourceMembers {
public:
    /// `x` by axis, in particle order. Throws if there are none.
    SourceMembers(const SourceUse& use, const Case& scene, const ParticleMedia& media, const Layout& layout, const double* const* x);

    const abi::Action action;

    /// Takes over the current positions from fields by axis.
    void follow(const double* const* x, int threads);
    /// The source's pressure and velocity, as wanted, at time t [s].
    void evaluate(double t, bool pressure, bool velocity, int threads);

    const std::vector<std::ptrdiff_t>& at() const { return at_; }    ///< places in a field
    const std::vector<int>& media() const { return media_; }         ///< numbers of their media
    std::vector<double>& p() { return p_; }
    const std::vector<double>& u(int axis) const { return u_[axis]; }

private:
    const abi::Source& source_;
    int dimension_;
    std::vector<std::ptrdiff_t> at_;
    std::vector<int> media_;
    std::vector<double> x_[3], p_, u_[3];
};

}    // namespace sphonic
