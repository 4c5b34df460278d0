#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "../staggered/bodies.hpp"
#include "scheme.hpp"

namespace fdtd {

using staggered::Field;

/// Bodies as the staircase of the cells whose points lie in them. No sound crosses a face of a rigid one, or of a free one. On a face of
/// a soft one p is zero: beyond it lies the image -p. At order 4 the differences that would reach into a body are those of order 2, and
/// so are their transposes in div u, which keeps the scheme's energy.
class Bodies {
public:
    Bodies(const abi::Scene& scene, const Grid& grid, int order) : grid_(grid), order_(order) {
        if (!scene.bodies) return;
        const PointSet all = grid.all(-1);
        const auto found = staggered::bodies_at(scene, all);
        body_.assign(std::size_t(grid.size), abi::Body::none);
        for (std::size_t i = 0; i < all.at.size(); ++i) {
            body_[all.at[i]] = found[i];
            if (found[i] != abi::Body::none) solid_.enlist(all.at[i]);
        }
        for (int a = 0; a < grid.dimension; ++a) grid.for_lines(a, [&](long line) { find(line, a); });
        for (auto& faces : soft_) std::sort(faces.begin(), faces.end());
    }

    bool any() const { return !body_.empty(); }
    void close_pressure(Field& p) const { solid_.clear(p.data()); }
    void close_velocity(Field* u) const {
        for (int a = 0; a < grid_.dimension; ++a) shut_[a].clear(u[a].data());
    }
    /// What a half of a step, made as if there were no bodies, is short of. `factor` is its h/(rho0 dx), or h K/dx.
    void mend_velocity(const Field& p, Field* u, double factor) const {
        for (int a = 0; a < grid_.dimension; ++a) mend(kicks_[a], p.data(), u[a].data(), factor);
        close_velocity(u);
    }
    void mend_pressure(const Field* u, double* p, double factor) const {
        for (int a = 0; a < grid_.dimension; ++a) mend(drifts_[a], u[a].data(), p, factor);
        solid_.clear(p);
    }
    /// True for a face of which a half belongs to a soft body.
    bool halved(int axis, std::size_t face) const { return std::binary_search(soft_[axis].begin(), soft_[axis].end(), face); }
    double bytes() const {
        double sum = double(body_.size());
        for (int a = 0; a < grid_.dimension; ++a) sum += double((kicks_[a].size() + drifts_[a].size()) * sizeof(Link)) + shut_[a].bytes() + 8.0 * double(soft_[a].size());
        return sum + solid_.bytes();
    }

private:
    /// Places in a field, one after the other where they can be.
    struct Stretches {
        struct Stretch {
            std::size_t first, n;
        };
        std::vector<Stretch> all;

        void enlist(std::size_t at) {
            if (all.empty() || all.back().first + all.back().n != at) all.push_back({at, 0});
            ++all.back().n;
        }
        void clear(double* field) const {
            for (const Stretch& s : all) std::fill_n(field + s.first, s.n, 0.0);
        }
        double bytes() const { return double(all.size() * sizeof(Stretch)); }
    };
    /// to -= factor * weight * from.
    struct Link {
        std::size_t to, from;
        double weight;
    };
    /// By which order 2 differs from order 4 at points i - 1 .. i + 2 about the face i + 1/2.
    static constexpr std::array<double, 4> lowered{-outer_weight, inner_weight - 1, 1 - inner_weight, outer_weight};

    const Grid& grid_;
    int order_;
    std::vector<abi::Body> body_;       ///< [grid.size]; empty without bodies
    Stretches solid_, shut_[3];
    std::vector<Link> kicks_[3], drifts_[3];
    std::vector<std::size_t> soft_[3];

    static void mend(const std::vector<Link>& links, const double* from, double* to, double factor) {
        for (const Link& l : links) to[l.to] -= factor * l.weight * from[l.from];
    }

    abi::Body body(long line, int axis, long i) const { return body_[std::size_t(line + grid_.image(axis, i) * grid_.stride[axis])]; }
    bool solid(long line, int axis, long i) const { return body(line, axis, i) != abi::Body::none; }
    /// Of the face beyond point i: nothing crosses it.
    bool shut(long line, int axis, long i) const {
        const abi::Body here = body(line, axis, i), there = body(line, axis, i + 1);
        const auto hard = [](abi::Body b) { return b == abi::Body::rigid || b == abi::Body::free; };
        return hard(here) || hard(there) || (here == abi::Body::soft && there == abi::Body::soft);
    }
    bool low(long line, int axis, long i) const {
        if (order_ == 2) return false;
        for (long k = i - 1; k <= i + 2; ++k)
            if (solid(line, axis, k)) return true;
        return false;
    }
    void find(long line, int axis) {
        const auto at = [&](long i) { return std::size_t(line + i * grid_.stride[axis]); };
        for (long i = -1; i < grid_.n[axis]; ++i) {
            if (shut(line, axis, i)) {
                shut_[axis].enlist(at(i));
                continue;
            }
            for (std::size_t k = 0; k < 4 && low(line, axis, i); ++k) kicks_[axis].push_back({at(i), at(i + long(k) - 1), lowered[k]});
            if (!solid(line, axis, i) && !solid(line, axis, i + 1)) continue;
            soft_[axis].push_back(at(i));
            kicks_[axis].push_back(solid(line, axis, i) ? Link{at(i), at(i + 1), 1} : Link{at(i), at(i), -1});
        }
        for (long j = 0; j < grid_.n[axis] && order_ > 2; ++j)
            for (long k = -2; k <= 1 && !solid(line, axis, j); ++k)
                if (!shut(line, axis, j + k) && low(line, axis, j + k)) drifts_[axis].push_back({at(j), at(j + k), lowered[std::size_t(k + 2)]});
    }
};

}    // namespace fdtd
