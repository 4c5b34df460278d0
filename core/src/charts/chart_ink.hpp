#pragma once
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace sphonic::charting {

struct Pixel {
    double x = 0, y = 0;    ///< from the bottom left of the picture
};

struct Box {
    double left = 0, bottom = 0, right = 0, top = 0;    ///< [px]

    double width() const { return right - left; }
    double height() const { return top - bottom; }
    Box grown(double by) const { return {left - by, bottom - by, right + by, top + by}; }
    /// Of this size around the same centre.
    Box resized(double wide, double high) const {
        const double x = (left + right) / 2, y = (bottom + top) / 2;
        return {x - wide / 2, y - high / 2, x + wide / 2, y + high / 2};
    }
    bool holds(const Box& b) const { return left <= b.left && bottom <= b.bottom && b.right <= right && b.top <= top; }
    double shared(const Box& b) const {
        return std::max(0.0, std::min(right, b.right) - std::max(left, b.left)) *
               std::max(0.0, std::min(top, b.top) - std::max(bottom, b.bottom));
    }
};

/// The part of a segment inside a box (Liang and Barsky 1984).
std::optional<std::pair<Pixel, Pixel>> clip(Pixel from, Pixel to, const Box& box);

/// What is already drawn in a frame, in cells of a few pixels: legends and labels look here for room.
class Ink {
public:
    explicit Ink(const Box& frame);

    void line(Pixel from, Pixel to);
    void box(const Box& box, int weight);
    int under(const Box& box) const;    ///< weight of all cells that the box touches

private:
    template <class Visit> void visit(const Box& box, Visit&& visit) const;

    Box frame_;
    int columns_, rows_;
    std::vector<int> weight_;
};

}    // namespace sphonic::charting
