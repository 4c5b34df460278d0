#pragma once
#include <cstdint>
#include <algorithm>
#include <span>
#include <vector>

#include <sphonic/plugin/abi/arrangement.hpp>

#include "period.hpp"

namespace sphonic {

/// For every particle of a set the others within radius + skin, among them virtual ones that are numbered after the set's
/// own and have no neighbours themselves. Periodic axes use the nearest image: the box must be at least twice the radius long.
class NeighbourList {
public:
    /// With a skin, rows are in an order in which particles close by follow each other; without, in that of the particles.
    NeighbourList(const abi::Box& box, long particles, double radius, double skin, int threads = 1);

    /// True until built, and again once a particle has moved by half the skin.
    bool outdated(const double* const* x) const { return start_.empty() || moved(x); }
    /// `x` of the set's own and of `images` virtual particles, which move as their sources do.
    void build(const double* const* x, long images);

    /// Twice the skin for lists to come, but no more than `most` [m].
    void widen(double most) { skin_ = std::min(2 * skin_, most); }

    const std::vector<std::int32_t>& order() const { return order_; }              ///< the particle of each row
    const std::vector<std::int64_t>& start() const { return start_; }              ///< first pair of each row, [particles + 1]
    /// Without a skin ascending in each row. There are `overrun` more values.
    std::span<const std::int32_t> neighbour() const { return {neighbour_.data(), std::size_t(start_.back())}; }
    /// Pairs within the bare radius, per particle.
    double mean_within_radius(const double* const* x) const;
    double bytes() const;

    int dimension() const { return box_.dimension; }
    double radius() const { return radius_; }
    double skin() const { return skin_; }
    /// Of an axis; 0 where it is not periodic.
    const Period& period(int axis) const { return period_[axis]; }

private:
    abi::Box box_;
    long n_;
    double radius_, skin_;
    int threads_;
    Period period_[3];
    std::vector<std::int32_t> order_;
    std::vector<std::int64_t> start_;
    std::vector<std::int32_t> neighbour_;
    std::vector<double> built_at_[3];

    bool moved(const double* const* x) const;
    void order_by_particle();
};

}    // namespace sphonic
