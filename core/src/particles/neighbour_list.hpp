#pragma once
#include <cstdint>
#include <vector>

#include <sphonic/plugin/abi/arrangement.hpp>

namespace sphonic {

/// Consecutive particles j, j + 1, ... among a particle's neighbours.
struct Run {
    std::int32_t j, count;
};

/// For every particle of a set the others within radius + skin, among them virtual ones that are numbered after the set's
/// own and have no neighbours themselves. Periodic axes use the nearest image: the box must be at least twice the radius long.
class NeighbourList {
public:
    NeighbourList(const abi::Box& box, long particles, double radius, double skin);

    /// True until built, and again once a particle has moved by half the skin.
    bool outdated(const double* const* x) const { return start_.empty() || moved(x); }
    /// `x` of the set's own and of `images` virtual particles, which move as their sources do.
    void build(const double* const* x, long images);

    const std::vector<std::int64_t>& start() const { return start_; }              ///< first pair of each particle, [particles + 1]
    const std::vector<std::int32_t>& neighbour() const { return neighbour_; }      ///< ascending for each particle
    const std::vector<std::int64_t>& first_run() const { return first_run_; }      ///< [particles + 1]
    const std::vector<Run>& runs() const { return runs_; }
    /// Pairs within the bare radius, per particle.
    double mean_within_radius(const double* const* x) const;
    double bytes() const;

    /// The nearest image of a separation along an axis; the identity on axes that are not periodic.
    double period(int axis) const { return period_[axis]; }

private:
    abi::Box box_;
    long n_;
    double radius_, skin_;
    double period_[3] = {0, 0, 0};
    std::vector<std::int64_t> start_;
    std::vector<std::int32_t> neighbour_;
    std::vector<std::int64_t> first_run_;
    std::vector<Run> runs_;
    std::vector<double> built_at_[3];

    bool moved(const double* const* x) const;
    void find_runs();
};

}    // namespace sphonic
