#include <array>
#include <cmath>

#include "chart_frame.hpp"

namespace sphonic::charting {

bool has_markers(const Curve& curve) {
    return curve.style != Curve::Style::line && curve.style != Curve::Style::dashed && curve.style != Curve::Style::cells;
}

double marker_size(const Curve& curve) {
    const auto n = curve.x.size();
    return n <= 60 ? 1.3 : n <= 400 ? 0.8 : 0.45;
}

Ink ink_of(const Panel& panel, const Frame& frame, double font) {
    Ink ink(frame.data);
    for (const Curve& curve : panel.curves) {
        const double radius = curve.style == Curve::Style::steps ? 0.38 : 0.23;    // [em] of a marker of size 1
        const double reach = has_markers(curve) ? radius * font * marker_size(curve) : 0;
        std::optional<Pixel> before;
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (!frame.x.shows(curve.x[i]) || !frame.y.shows(curve.y[i])) {
                before.reset();
                continue;
            }
            const Pixel p = frame.at(curve.x[i], curve.y[i]);
            if (curve.style == Curve::Style::cells) {
                const Pixel low = frame.at(curve.x[i] - curve.cell_width / 2, curve.y[i] - curve.cell_height / 2);
                const Pixel high = frame.at(curve.x[i] + curve.cell_width / 2, curve.y[i] + curve.cell_height / 2);
                ink.box({low.x, low.y, high.x, high.y}, 1);
                continue;
            }
            if (reach > 0) ink.box({p.x - reach, p.y - reach, p.x + reach, p.y + reach}, 5);
            if (before && curve.style == Curve::Style::steps) {
                ink.line(*before, {p.x, before->y});
                ink.line({p.x, before->y}, p);
            } else if (before && curve.style != Curve::Style::points) {
                ink.line(*before, p);
            }
            before = p;
        }
    }
    return ink;
}

namespace {

struct Seat {
    Box box;
    double distance;     ///< from the point [em]
    double preference;
};

/// Seats around a point: right, left, above and below are preferred to those between, near ones to far ones.
std::vector<Seat> seats(const PointLabel& label, double font) {
    const double w = label.box.width(), h = label.box.height();
    std::vector<Seat> found;
    constexpr int directions = 16;
    for (const double distance : {0.8, 1.1, 1.7, 2.6, 3.7, 5.0, 6.5, 8.0, 10.0, 12.0})
        for (int k = 0; k < directions; ++k) {
            const double turn = 2 * std::acos(-1.0) * k / directions;
            const double dx = std::cos(turn), dy = std::sin(turn);
            const double reach = distance * font;
            const Pixel centre{label.point.x + dx * reach + w / 2 * std::clamp(2 * dx, -1.0, 1.0),
                               label.point.y + dy * reach + h / 2 * std::clamp(2 * dy, -1.0, 1.0)};
            const double between = 0.4 * (k % 4 != 0) + 0.3 * (k % 2);
            const double preference = between + (dx < -0.1 ? 0.3 : 0) + (dy < -0.1 ? 0.1 : 0);
            const Box box{centre.x - w / 2, centre.y - h / 2, centre.x + w / 2, centre.y + h / 2};
            found.push_back({box, distance, preference});
        }
    return found;
}

Pixel nearest(const Box& box, Pixel p) {
    return {std::clamp(p.x, box.left, box.right), std::clamp(p.y, box.bottom, box.top)};
}

double cost_of(const Seat& seat, std::size_t self, const std::vector<PointLabel>& labels, const Box& room,
               const Ink& ink, double font) {
    const Box& b = seat.box;
    double cost = 3 * seat.distance + seat.preference + 1.2 * ink.under(b.grown(0.12 * font));
    if (!room.holds(b)) cost += 1e4;
    const Pixel point = labels[self].point, end = nearest(b, point);
    const Box wide{b.left - 0.4 * font, b.bottom, b.right + 0.4 * font, b.top};
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (i == self) continue;
        const PointLabel& other = labels[i];
        const double shared = wide.shared(other.box);
        if (shared > 0) cost += 100 + shared;
        if (clip(point, end, other.box)) cost += 60;
        if (clip(other.point, nearest(other.box, other.point), b)) cost += 60;
    }
    return cost;
}

std::vector<PointLabel> labels_of(const Panel& panel, const Frame& frame, double font) {
    std::vector<PointLabel> labels;
    for (const Curve& curve : panel.curves)
        for (std::size_t i = 0; i < curve.point_labels.size(); ++i) {
            const double x = curve.x[i], y = curve.y[i];
            if (curve.point_labels[i].empty() || !frame.x.shows(x) || !frame.y.shows(y)) continue;
            if (!frame.x.contains(x) || !frame.y.contains(y)) continue;
            const double width = text_width(curve.point_labels[i], font);
            labels.push_back({curve.point_labels[i], frame.at(x, y), {0, 0, width, 1.15 * font}});
        }
    return labels;
}

}    // namespace

std::vector<PointLabel> place_labels(const Panel& panel, const Frame& frame, const Ink& ink, double font) {
    std::vector<PointLabel> labels = labels_of(panel, frame, font);
    std::vector<std::vector<Seat>> choices;
    for (PointLabel& label : labels) {
        choices.push_back(seats(label, font));
        label.box = choices.back().front().box;
    }
    Box room = frame.data;
    room.left += 0.3 * font;
    if (frame.legend.place != Legend::Place::beside) room.right = frame.cell.right - 0.4 * font;
    constexpr int sweeps = 6;
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 0; i < labels.size(); ++i) {
            double least = 1e300;
            Seat best = choices[i].front();
            for (const Seat& seat : choices[i]) {
                const double cost = cost_of(seat, i, labels, room, ink, font);
                if (cost < least) least = cost, best = seat;
            }
            labels[i].box = best.box;
            labels[i].leader = best.distance > 1.2;
        }
    return labels;
}

}    // namespace sphonic::charting
