#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "../staggered/grid.hpp"

namespace fdtd {

using staggered::End;
using staggered::Ends;
using staggered::Field;
using staggered::Grid;

inline std::string name_of(int axis, bool upper) { return std::string(1, "xyz"[axis]) + (upper ? "_max" : "_min"); }

/// What the faces of a scene are to a staggered grid. A face without a boundary, or a free one, is a rigid wall half a spacing beyond.
inline Ends ends_of(const abi::Scene& scene, int order) {
    Ends ends{};
    for (int a = 0; a < scene.box.dimension; ++a)
        for (const bool upper : {false, true}) {
            End& end = ends[std::size_t(a)][upper];
            const abi::Boundary* face = scene.face[a][upper];
            const abi::Closure closure = face ? face->closure() : abi::Closure::free;
            const std::string place = "the boundary of " + name_of(a, upper);
            if (closure == abi::Closure::free) end = End::half_way;
            if (closure == abi::Closure::periodic) end = End::wrap;
            if (closure == abi::Closure::mirror) {
                if (face->admittance() > 0) throw std::invalid_argument(place + " gives way, which this grid's walls do not: choose rigid or soft, or method \"particles\"");
                if (face->parity(abi::Part::scalar) == face->parity(abi::Part::normal))
                    throw std::invalid_argument(place + " takes p and the velocity across it alike, which no wall of a staggered grid does: choose rigid or soft");
                end = face->half_way() ? End::half_way : End::on_points;
            }
            if (closure != abi::Closure::layers) continue;
            if (!face->pressure_suffices())
                throw std::invalid_argument(place + " needs all fields at one place, and this grid is staggered: choose another boundary, or method \"particles\"");
            if (order > 2) throw std::invalid_argument(place + " is made for one layer of points, and order 4 needs two: choose order 2, or an absorbing_layer");
            end = End::open;
        }
    return ends;
}

/// The ghosts of p and u that make mirror walls and periodic axes.
class Walls {
public:
    Walls(const abi::Scene& scene, const Grid& grid) : grid_(grid) {
        for (int a = 0; a < grid.dimension; ++a)
            for (const bool upper : {false, true}) {
                const End end = grid.ends[std::size_t(a)][upper];
                const abi::Boundary* face = scene.face[a][upper];
                const double even = face && end != End::wrap && end != End::open ? face->parity(abi::Part::scalar) : 1;
                const long last = grid.n[a] - 1, half = end == End::half_way;
                pressure_[a][upper] = {end, upper ? 2 * last + half : -half, even};
                velocity_[a][upper] = {end, upper ? 2 * last - 1 + half : -1 - half, -even};
            }
    }

    void close_pressure(Field& p, int axis) const {
        grid_.for_lines(axis, [&](long line) { close(p.data() + line, axis, pressure_[axis]); });
    }
    /// All, twice: what vanishes on a wall of one axis was mirrored at that of another.
    void close_pressure(Field& p) const {
        for (int pass = 0; pass < 2; ++pass)
            for (int a = 0; a < grid_.dimension; ++a) close_pressure(p, a);
    }
    /// The ends of a row along x.
    void close_row(double* p) const { close(p, 0, pressure_[0]); }

    /// u_a at both ends of axis a.
    void close_velocity(Field* u, int a) const {
        grid_.for_lines(a, [&](long line) { close(u[a].data() + line, a, velocity_[a]); });
    }
    void close_velocity(Field* u) const {
        for (int a = 0; a < grid_.dimension; ++a) close_velocity(u, a);
    }
    /// The same of one row along x.
    void close_velocity_row(double* u) const { close(u, 0, velocity_[0]); }

    /// What a point of p (`half` 0), or of u along the axis (1), counts for in sums over the box: half of it lies beyond a wall through it.
    double weight(int axis, long i, int half) const {
        const long last = grid_.n[axis] - 1;
        double w = 1;
        for (const bool upper : {false, true}) {
            const Mirror& m = half ? velocity_[axis][upper] : pressure_[axis][upper];
            if (m.end == End::wrap && (i < 0 || i > last)) w = 0;
            if (m.end != End::on_points && m.end != End::half_way) continue;
            if (2 * i == m.sum) w = 0.5;
            if (upper ? 2 * i > m.sum : 2 * i < m.sum) w = 0;
        }
        return w;
    }

private:
    /// Point i is `sign` times point `sum` - i.
    struct Mirror {
        End end = End::half_way;
        long sum = 0;
        double sign = 1;
    };
    const Grid& grid_;
    Mirror pressure_[3][2], velocity_[3][2];

    void close(double* line, int axis, const Mirror (&ends)[2]) const {
        const long n = grid_.n[axis], g = grid_.ghosts, step = grid_.stride[axis];
        const auto mirror = [&](const Mirror& m, long i) {
            if (2 * i != m.sum)
                line[i * step] = m.sign * line[(m.sum - i) * step];
            else if (m.sign < 0)
                line[i * step] = 0;
        };
        if (ends[0].end == End::wrap) {
            for (long i = 1; i <= g; ++i) {
                line[-i * step] = line[(n - i) * step];
                line[(n - 1 + i) * step] = line[(i - 1) * step];
            }
            return;
        }
        if (ends[0].end != End::open)
            for (long i = (ends[0].sum - 1) / 2; i >= -g; --i) mirror(ends[0], i);
        if (ends[1].end != End::open)
            for (long i = (ends[1].sum + 1) / 2; i < n + g; ++i) mirror(ends[1], i);
    }
};

}    // namespace fdtd
