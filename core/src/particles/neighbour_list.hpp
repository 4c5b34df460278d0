#pragma once
#include <cstdint>
#include <vector>

#include <sphonic/plugin/abi/arrangement.hpp>

namespace sphonic {

/// Consecutive particles j, j + 1, ... among a particle's neighbours.
struct Run {
    std::int32_t j, count;
};

/// For every particle the others within radius + skin, rebuilt when any of them has moved by half the skin.
/// Periodic axes use the nearest image: the box must be at least twice the radius long.
class NeighbourList {
public:
    NeighbourList(const abi::Box& box, long particles, double radius, double skin);

    /// Rebuilds if needed; true if it did.
    bool update(const double* const* x);

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
    void build(const double* const* x);
    void find_runs();
};

}    // namespace sphonic
