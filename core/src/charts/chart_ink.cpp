#include "chart_ink.hpp"

#include <array>
#include <cmath>

namespace sphonic::charting {

namespace {

constexpr double cell = 4;    // [px]

}    // namespace

std::optional<std::pair<Pixel, Pixel>> clip(Pixel from, Pixel to, const Box& box) {
    const double dx = to.x - from.x, dy = to.y - from.y;
    double enter = 0, leave = 1;
    const std::array<std::pair<double, double>, 4> edges{
        {{-dx, from.x - box.left}, {dx, box.right - from.x}, {-dy, from.y - box.bottom}, {dy, box.top - from.y}}};
    for (const auto& [speed, distance] : edges) {
        if (speed == 0 && distance < 0) return std::nullopt;
        if (speed < 0) enter = std::max(enter, distance / speed);
        if (speed > 0) leave = std::min(leave, distance / speed);
    }
    if (!(enter <= leave)) return std::nullopt;
    return std::pair{Pixel{from.x + enter * dx, from.y + enter * dy}, Pixel{from.x + leave * dx, from.y + leave * dy}};
}

Ink::Ink(const Box& frame)
    : frame_(frame),
      columns_(std::max(1, static_cast<int>(std::ceil(frame.width() / cell)))),
      rows_(std::max(1, static_cast<int>(std::ceil(frame.height() / cell)))),
      weight_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

template <class Visit> void Ink::visit(const Box& box, Visit&& visit) const {
    const auto index = [](double distance, int count) {
        return static_cast<int>(std::clamp(std::floor(distance / cell), 0.0, count - 1.0));
    };
    if (box.right < frame_.left || box.left > frame_.right) return;
    if (box.top < frame_.bottom || box.bottom > frame_.top) return;
    const int right = index(box.right - frame_.left, columns_), top = index(box.top - frame_.bottom, rows_);
    for (int row = index(box.bottom - frame_.bottom, rows_); row <= top; ++row)
        for (int column = index(box.left - frame_.left, columns_); column <= right; ++column)
            visit(static_cast<std::size_t>(row * columns_ + column));
}

void Ink::line(Pixel from, Pixel to) {
    const auto seen = clip(from, to, frame_);
    if (!seen) return;
    const auto [a, b] = *seen;
    const int steps = 1 + static_cast<int>(2 * std::hypot(b.x - a.x, b.y - a.y) / cell);
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps, x = a.x + t * (b.x - a.x), y = a.y + t * (b.y - a.y);
        visit({x, y, x, y}, [this](std::size_t at) { weight_[at] = std::max(weight_[at], 1); });
    }
}

void Ink::box(const Box& box, int weight) {
    visit(box, [&](std::size_t at) { weight_[at] = std::max(weight_[at], weight); });
}

int Ink::under(const Box& box) const {
    int sum = 0;
    visit(box, [&](std::size_t at) { sum += weight_[at]; });
    return sum;
}

}    // namespace sphonic::charting
