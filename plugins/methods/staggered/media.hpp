#pragma once
#include <algorithm>
#include <vector>

#include "grid.hpp"

namespace staggered {

/// K = rho0 c0^2 at the points of p and 1/rho0 at those of u, as means over their cells where media meet. Compressions add up: the
/// harmonic mean of K. For u_a the masses along axis a add up, the accelerations of lines side by side too: the mean over the lines of
/// 1 / (arithmetic mean of rho0 along the line). So an interface may lie anywhere between points, and reflects rightly to the second order.
class Media {
public:
    Field bulk, lightness[3];    ///< [grid.size]; empty where there is one medium

    Media(const abi::Scene& scene, const Grid& grid)
        : grid_(grid), media_(scene.media), list_(scene.media.medium, scene.media.medium + scene.media.count) {
        if (list_.empty()) list_.push_back(scene.medium);
        if (uniform()) return;
        const PointSet all = grid.all(-1);
        std::vector<int> found(all.at.size());
        media_.find(media_.host, all.points(), found.data());
        number_.assign(std::size_t(grid.size), 0);
        for (std::size_t i = 0; i < all.at.size(); ++i) number_[all.at[i]] = found[i];
        bulk.assign(std::size_t(grid.size), 0.0);
        for (const std::size_t at : all.at) bulk[at] = bulk_at(long(at));
        for (int a = 0; a < grid.dimension; ++a) {
            lightness[a].assign(std::size_t(grid.size), 0.0);
            grid.for_lines(a, [&](long line) {
                for (long i = -grid.ghosts; i < grid.n[a] + std::max(grid.ghosts - 1, 0L); ++i)
                    lightness[a][std::size_t(line + i * grid.stride[a])] = lightness_beyond(line, a, i);
            });
        }
    }

    bool uniform() const { return list_.size() == 1; }
    const abi::Medium& of(std::size_t at) const { return list_[uniform() ? 0 : std::size_t(number_[at])]; }
    const abi::Medium& fastest() const {
        return *std::max_element(list_.begin(), list_.end(), [](const auto& a, const auto& b) { return a.c0 < b.c0; });
    }
    double bulk_of(std::size_t at) const { return uniform() ? modulus(list_[0]) : bulk[at]; }
    double density_of(int axis, std::size_t at) const { return uniform() ? list_[0].rho0 : 1 / lightness[axis][at]; }
    static double modulus(const abi::Medium& m) { return m.rho0 * m.c0 * m.c0; }

private:
    const Grid& grid_;
    abi::Media media_;
    std::vector<abi::Medium> list_;
    std::vector<int> number_;    ///< of the medium at each point of p

    static constexpr int samples[4] = {0, 64, 8, 4};    ///< per axis of a cell, by dimension

    /// True if the medium of a point is that of its neighbours too.
    bool alone(long at) const {
        const auto site = grid_.site(at);
        for (int a = 0; a < grid_.dimension; ++a)
            for (const long by : {-1, 1}) {
                const long i = site[std::size_t(a)];
                if (number_[std::size_t(at + (grid_.image(a, i + by) - i) * grid_.stride[a])] != number_[std::size_t(at)]) return false;
            }
        return true;
    }
    /// The medium at a place in the cell about a point, each coordinate in units of dx.
    const abi::Medium& medium_at(long at, const double (&place)[3]) const {
        const auto site = grid_.site(at);
        double x[3] = {0, 0, 0};
        for (int a = 0; a < grid_.dimension; ++a) x[a] = grid_.lower[a] + grid_.fold(a, double(site[std::size_t(a)]) + place[a]) * grid_.dx;
        const abi::Points one{.dimension = grid_.dimension, .n = 1, .x = {x, x + 1, x + 2}};
        int number = 0;
        media_.find(media_.host, one, &number);
        return list_[std::size_t(number)];
    }
    double bulk_at(long at) const {
        if (alone(at)) return modulus(of(std::size_t(at)));
        const int d = grid_.dimension, m = samples[d], total = d == 1 ? m : d == 2 ? m * m : m * m * m;
        double compliance = 0;
        for (int s = 0; s < total; ++s) {
            double place[3] = {0, 0, 0};
            for (int a = 0, rest = s; a < d; ++a, rest /= m) place[a] = (rest % m + 0.5) / m - 0.5;
            compliance += 1 / modulus(medium_at(at, place));
        }
        return total / compliance;
    }
    /// Between points i and i + 1 of a line, one of which may lie beyond an end.
    double lightness_beyond(long line, int axis, long i) const {
        const long here = line + grid_.image(axis, i) * grid_.stride[axis], there = line + grid_.image(axis, i + 1) * grid_.stride[axis];
        const double rho = of(std::size_t(here)).rho0;
        if (number_[std::size_t(here)] == number_[std::size_t(there)] && alone(here) && alone(there)) return 1 / rho;
        const int d = grid_.dimension, m = samples[d], lines = d == 1 ? 1 : d == 2 ? m : m * m;
        double sum = 0;
        for (int l = 0; l < lines; ++l) {
            double mass = 0;
            for (int s = 0; s < m; ++s) {
                double place[3] = {0, 0, 0};
                for (int a = 0, rest = l; a < d; ++a) {
                    if (a == axis) continue;
                    place[a] = (rest % m + 0.5) / m - 0.5;
                    rest /= m;
                }
                place[axis] = double(i) + (s + 0.5) / m;
                mass += medium_at(line, place).rho0;
            }
            sum += m / mass;
        }
        return sum / lines;
    }
};

}    // namespace staggered
