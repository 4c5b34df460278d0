#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include <sphonic/plugin/point_set.hpp>

#include "field.hpp"

namespace staggered {

/// What a grid meets at one end of an axis.
enum class End {
    wrap,         ///< its other end
    on_points,    ///< a mirror on the last points of p
    half_way,     ///< a mirror half a spacing beyond them, on points of u
    open          ///< points beyond, whose values come from elsewhere
};
using Ends = std::array<std::array<End, 2>, 3>;    ///< [axis][upper]

/// Points lower + i dx of p, x fastest, with `ghosts` more beyond every face; those of u_a lie half a spacing further along axis a.
struct Grid {
    int dimension;
    double dx, lower[3];    ///< [m]
    long n[3] = {1, 1, 1}, stride[3] = {1, 0, 0}, before[3] = {0, 0, 0}, ghosts, origin = 0, size = 1;    ///< `before`: places ahead of an axis's first point
    Ends ends;

    Grid(const abi::Box& box, long ghosts, const Ends& ends) : dimension(box.dimension), dx(box.dx), ghosts(ghosts), ends(ends) {
        for (int a = 0; a < dimension; ++a) {
            n[a] = box.count[a];
            lower[a] = box.lower[a];
            stride[a] = size;
            before[a] = a == 0 && ghosts > 0 ? line : ghosts;    // with ghosts, rows begin on cache lines
            origin += before[a] * stride[a];
            size *= n[a] + before[a] + ghosts;
            if (a == 0 && ghosts > 0) size = (size + line - 1) / line * line;
        }
    }

    static constexpr long line = 8;    ///< numbers in a cache line

    long points() const { return n[0] * n[1] * n[2]; }
    double cell() const { return dimension == 1 ? dx : dimension == 2 ? dx * dx : dx * dx * dx; }

    /// Calls row(first point) for each row along x.
    template <class Row>
    void for_rows(Row row) const {
        for (long k = 0; k < n[2]; ++k)
            for (long j = 0; j < n[1]; ++j) row(origin + j * stride[1] + k * stride[2]);
    }
    /// Calls line(first point) for each line along the axis, neighbouring ones one after the other.
    template <class Line>
    void for_lines(int axis, Line line) const {
        const int b = axis == 0 ? 1 : 0, c = axis == 2 ? 1 : 2;
        for (long k = 0; k < n[c]; ++k)
            for (long j = 0; j < n[b]; ++j) line(origin + j * stride[b] + k * stride[c]);
    }

    /// The point's number along each axis.
    std::array<long, 3> site(long at) const {
        std::array<long, 3> i{};
        for (int a = dimension - 1; a >= 0; --a) {
            i[std::size_t(a)] = at / stride[a] - before[a];
            at %= stride[a];
        }
        return i;
    }
    /// Where in the box, in spacings from its first point, the medium is found that counts for a place beyond an end.
    double fold(int axis, double s) const {
        const Ends::value_type& at = ends[std::size_t(axis)];
        const double last = double(n[axis] - 1);
        if (at[0] == End::wrap) return s < -0.5 ? s + last + 1 : s >= last + 0.5 ? s - last - 1 : s;
        const double low = at[0] == End::on_points ? 0 : -0.5, high = at[1] == End::on_points ? last : last + 0.5;
        return s < low ? 2 * low - s : s > high ? 2 * high - s : s;
    }
    long image(int axis, long i) const { return std::lround(fold(axis, double(i))); }

    /// All points of p, or, with an axis, of u along it, to which those on a lower face belong.
    PointSet all(int staggered) const {
        PointSet set{.dimension = dimension, .at = {}, .x = {}, .value = {}};
        long first[3] = {0, 0, 0};
        if (staggered >= 0 && (ends[std::size_t(staggered)][0] == End::half_way || ends[std::size_t(staggered)][0] == End::open)) first[staggered] = -1;
        for (long k = first[2]; k < n[2]; ++k)
            for (long j = first[1]; j < n[1]; ++j)
                for (long i = first[0]; i < n[0]; ++i) {
                    const long site[3] = {i, j, k};
                    set.at.push_back(std::size_t(origin + i + j * stride[1] + k * stride[2]));
                    for (int a = 0; a < dimension; ++a) set.x[a].push_back(lower[a] + (double(site[a]) + (a == staggered ? 0.5 : 0)) * dx);
                }
        set.value.resize(set.at.size());
        return set;
    }
};

}    // namespace staggered
