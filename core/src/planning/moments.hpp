#pragma once
#include <algorithm>
#include <cmath>

namespace sphonic {

/// Of the end, at which set-ups are compared as well: later ones tell a phase better, and it must be no whole share of a period.
inline constexpr double other_moment = 0.93;

inline long other_step(long steps) { return std::max(1L, std::lround(other_moment * double(steps))); }

/// Sums over a set at one time: squares of what p is off by, and of what it should be [Pa^2].
struct Moment {
    double error = 0, power = 0;
};

/// Relative error at the end, or that of the other moment over the sound of the louder where it is larger: at one alone a wave that is late by a whole
/// period looks right, and a standing one at its height hardly shows that it is late.
inline double worst_l2(const Moment& other, const Moment& end) {
    return std::max(std::sqrt(end.error / end.power), std::sqrt(other.error / std::max(other.power, end.power)));
}

}    // namespace sphonic
