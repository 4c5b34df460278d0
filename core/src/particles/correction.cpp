#include "correction.hpp"

#include <cmath>

namespace sphonic {
namespace {

/// Below this determinant a neighbourhood counts as degenerate; that of a particle in a corner of the box is some 1e-2.
constexpr double least_determinant = 1e-6;

}    // namespace

std::optional<std::array<double, 9>> Moment::inverse() const {
    std::array<double, 9> m = m_;
    for (int a = d_; a < 3; ++a) m[std::size_t(4 * a)] = 1;
    const auto minor = [&](int i, int j) {
        const auto at = [&](int r, int c) { return m[std::size_t(3 * ((i + r) % 3) + (j + c) % 3)]; };
        return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
    };
    const double determinant = m[0] * minor(0, 0) + m[1] * minor(0, 1) + m[2] * minor(0, 2);
    if (!(std::abs(determinant) >= least_determinant)) return std::nullopt;
    std::array<double, 9> inverse{};
    for (int a = 0; a < d_; ++a)
        for (int b = 0; b < d_; ++b) inverse[std::size_t(3 * a + b)] = minor(b, a) / determinant;
    return inverse;
}

}    // namespace sphonic
