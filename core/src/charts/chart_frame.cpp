#include "chart_frame.hpp"

#include <cmath>

namespace sphonic::charting {

namespace {

using Place = Legend::Place;

constexpr double line_height = 1.45, sample = 4.2;    // of the legend [em]

double legend_height(int rows, double font) { return (rows * line_height + 0.8) * font; }

int entries_of(const Panel& panel) {
    return static_cast<int>(std::ranges::count_if(panel.curves, [](const Curve& c) { return !c.label.empty(); }));
}

Legend legend_of(const Panel& panel, double font) {
    Legend legend;
    if (!panel.legend || panel.raster || entries_of(panel) == 0) return legend;
    for (const Curve& curve : panel.curves) {
        const auto letters = std::ranges::count_if(curve.label, [](char c) { return (c & 0xC0) != 0x80; });
        legend.widest = std::max(legend.widest, text_width(curve.label, 1));
        legend.longest = std::max(legend.longest, static_cast<double>(letters));
    }
    legend.place = Place::top_right;
    legend.width = (legend.widest + sample) * font;
    legend.height = legend_height(entries_of(panel), font);
    return legend;
}

/// The rectangle of the data and the ticks that determine it.
void fit_data(Frame& frame, const Panel& panel, double font) {
    const bool beside = frame.legend.place == Place::beside, below = frame.legend.place == Place::below;
    double side = beside ? frame.legend.width + font : 0;
    const double under = below ? frame.legend.height + 0.4 * font : 0;
    Box& data = frame.data;
    data.top = frame.cell.top - (panel.title.empty() ? 0.8 : 2.2) * font;
    const double outside = tick_length(panel, font);
    data.bottom = frame.cell.bottom + outside + (panel.x.label.empty() ? 2.4 : 3.9) * font + under;
    frame.y_ticks = ticks_of(frame.y, std::max(data.height(), font), font, false);
    if (panel.raster) side = bar_room(frame, *panel.raster, font);
    data.left = frame.cell.left + widest(frame.y_ticks, font) + (panel.y.label.empty() ? 1.2 : 3.0) * font + outside;
    data.right = frame.cell.right - 1.6 * font - side;
    frame.x_ticks = ticks_of(frame.x, std::max(data.width(), font), font, true);
    data.right = std::min(data.right, frame.cell.right - side - 0.5 * widest(frame.x_ticks, font) - 0.4 * font);
    frame.room = data;
    if (panel.raster) fit_raster(frame, *panel.raster, font);
    frame.x_ticks = ticks_of(frame.x, std::max(data.width(), font), font, true);
}

/// The first corner with nothing in it, else below the data or, where that takes too much height, beside it.
void place_legend(Frame& frame, const Panel& panel, double font) {
    Legend& legend = frame.legend;
    if (legend.place == Place::none) return;
    const Ink ink = ink_of(panel, frame, font);
    for (const Place place : {Place::top_right, Place::top_left, Place::bottom_right, Place::bottom_left}) {
        legend.place = place;
        const Box box = frame.legend_box(font);
        if (frame.data.holds(box) && ink.under(box) == 0) return;
    }
    const int entries = entries_of(panel);
    const int columns = std::clamp(static_cast<int>(frame.data.width() / legend.width), 1, entries);
    const double below = legend_height((entries + columns - 1) / columns, font);
    legend.place = Place::beside;
    if (below < 0.2 * frame.cell.height() || legend.width > 0.3 * frame.cell.width()) {
        legend.place = Place::below;
        legend.columns = columns;
        legend.height = below;
    }
    fit_data(frame, panel, font);
}

Frame frame_of(const Panel& panel, const Box& cell, double font) {
    Frame frame{.cell = cell, .data = {}, .room = {}, .bar = {}, .x = x_scale(panel), .y = y_scale(panel),
                .x_ticks = {}, .y_ticks = {}, .bar_ticks = {}, .legend = legend_of(panel, font), .labels = {}};
    fit_data(frame, panel, font);
    place_legend(frame, panel, font);
    Ink ink = ink_of(panel, frame, font);
    if (frame.legend_inside()) ink.box(frame.legend_box(0.7 * font), 20);
    frame.labels = place_labels(panel, frame, ink, font);
    return frame;
}

}    // namespace

bool Frame::legend_inside() const {
    return legend.place != Place::none && legend.place != Place::beside && legend.place != Place::below;
}

Box Frame::legend_box(double gap) const {
    const double w = legend.width + gap, h = legend.height + gap;
    const bool top = legend.place == Place::top_left || legend.place == Place::top_right;
    const bool left = legend.place == Place::top_left || legend.place == Place::bottom_left;
    return {left ? data.left : data.right - w, top ? data.top - h : data.bottom, left ? data.left + w : data.right,
            top ? data.top : data.bottom + h};
}

double font_of(const Chart& chart) {
    const double width = chart.width / 1000.0, height = chart.height / 600.0;
    return base_font * std::max(1.0, std::min(width, std::sqrt(width * height)));
}

double fitted(const std::string& text, double font, double pixels) {
    return font * std::clamp(pixels / std::max(1.0, text_width(text, font)), 0.5, 1.0);
}

std::vector<Frame> lay_out(const Chart& chart) {
    const double font = font_of(chart), head = chart.title.empty() ? 0 : 2.2 * font;
    const int columns = std::max(1, chart.columns);
    std::vector<std::pair<int, int>> starts;    // row and column
    int row = 0, column = 0;
    for (const Panel& panel : chart.panels) {
        const int span = std::clamp(panel.span, 1, columns);
        if (column + span > columns) ++row, column = 0;
        starts.emplace_back(row, column);
        column += span;
    }
    const double width = static_cast<double>(chart.width) / columns, height = (chart.height - head) / (row + 1);
    std::vector<Frame> frames;
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const auto [r, c] = starts[i];
        const int span = std::clamp(chart.panels[i].span, 1, columns);
        const double top = chart.height - head - r * height;
        frames.push_back(frame_of(chart.panels[i], {c * width, top - height, (c + span) * width, top}, font));
    }
    return frames;
}

}    // namespace sphonic::charting
