#include "contour.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <list>
#include <utility>

namespace sphonic {
namespace {

struct Point {
    double x, y;
    bool operator==(const Point&) const = default;
};
using Piece = std::list<Point>;

/// Joins a segment to the pieces that end where it does: shared points are computed alike, to the bit.
void join(std::list<Piece>& pieces, Point from, Point to) {
    const auto ending = [&](Point at) {
        for (auto piece = pieces.begin(); piece != pieces.end(); ++piece)
            if (piece->front() == at || piece->back() == at) return piece;
        return pieces.end();
    };
    auto before = ending(from);
    if (before == pieces.end()) before = pieces.insert(pieces.end(), Piece{from});
    if (before->front() == from && before->back() != from) before->reverse();
    const auto after = ending(to);
    if (after == pieces.end() || after == before) return before->push_back(to);
    if (after->back() == to && after->front() != to) after->reverse();
    before->splice(before->end(), *after);
    pieces.erase(after);
}

}    // namespace

Lines zero_lines(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& value,
                 const std::function<double(double x, double y)>& exact) {
    const auto at = [&](std::size_t i, std::size_t j) { return value[j * x.size() + i]; };
    const auto between = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        const auto place = [&](double s) { return Point{x[i] + s * (x[k] - x[i]), y[j] + s * (y[l] - y[j])}; };
        const double a = at(i, j), b = at(k, l);
        if (!exact) return place(a / (a - b));
        double low = 0, high = 1;
        for (int halving = 0; halving < 20; ++halving) {
            const Point middle = place(0.5 * (low + high));
            ((exact(middle.x, middle.y) > 0) == (a > 0) ? low : high) = 0.5 * (low + high);
        }
        return place(0.5 * (low + high));
    };
    std::list<Piece> pieces;
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            const auto differ = [&](double a, double b) { return std::isfinite(a) && std::isfinite(b) && (a > 0) != (b > 0); };
            std::vector<Point> crossed;
            if (differ(at(i, j), at(i + 1, j))) crossed.push_back(between(i, j, i + 1, j));
            if (differ(at(i + 1, j), at(i + 1, j + 1))) crossed.push_back(between(i + 1, j, i + 1, j + 1));
            if (differ(at(i, j + 1), at(i + 1, j + 1))) crossed.push_back(between(i, j + 1, i + 1, j + 1));
            if (differ(at(i, j), at(i, j + 1))) crossed.push_back(between(i, j, i, j + 1));
            for (std::size_t k = 0; k + 1 < crossed.size(); k += 2) join(pieces, crossed[k], crossed[k + 1]);
        }
    Lines lines;
    for (const Piece& piece : pieces) {
        for (const Point& p : piece) lines.x.push_back(p.x), lines.y.push_back(p.y);
        lines.x.push_back(std::numeric_limits<double>::quiet_NaN());
        lines.y.push_back(lines.x.back());
    }
    return lines;
}

}    // namespace sphonic
