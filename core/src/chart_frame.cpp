#include "chart_frame.hpp"

#include <cmath>

namespace sphonic::charting {

namespace {

using Place = Legend::Place;

constexpr double line_height = 1.45, sample = 4.2;    // of the legend [em]

Legend legend_of(const Panel& panel, double font) {
    Legend legend;
    double widest = 0;
    int entries = 0;
    for (const Curve& curve : panel.curves) {
        if (curve.label.empty()) continue;
        widest = std::max(widest, text_width(curve.label, font));
        ++entries;
    }
    if (!panel.legend || entries == 0) return legend;
    legend.place = Place::top_right;
    legend.width = widest + (sample + 1) * font;
    legend.height = (entries * line_height + 0.6) * font;
    return legend;
}

Box corner(const Frame& frame, Place place, double gap) {
    const Legend& l = frame.legend;
    const Box& d = frame.data;
    const double w = l.width + gap, h = l.height + gap;
    switch (place) {
        case Place::top_left: return {d.left, d.top - h, d.left + w, d.top};
        case Place::bottom_right: return {d.right - w, d.bottom, d.right, d.bottom + h};
        case Place::bottom_left: return {d.left, d.bottom, d.left + w, d.bottom + h};
        default: return {d.right - w, d.top - h, d.right, d.top};
    }
}

/// The rectangle of the data and the ticks that determine it.
void fit_data(Frame& frame, const Panel& panel, double font) {
    const bool beside = frame.legend.place == Place::beside, below = frame.legend.place == Place::below;
    const double side = beside ? frame.legend.width + font : 0, under = below ? frame.legend.height + 0.4 * font : 0;
    Box& data = frame.data;
    data.top = frame.cell.top - (panel.title.empty() ? 0.8 : 2.2) * font;
    data.bottom = frame.cell.bottom + (panel.x.label.empty() ? 2.2 : 3.7) * font + under;
    frame.y_ticks = ticks_of(frame.y, std::max(data.height(), font), font, false);
    double widest = 0;
    for (const Tick& tick : frame.y_ticks) widest = std::max(widest, text_width(tick.text, font));
    data.left = frame.cell.left + widest + (panel.y.label.empty() ? 1.2 : 3.0) * font;
    data.right = frame.cell.right - 1.6 * font - side;
    frame.x_ticks = ticks_of(frame.x, std::max(data.width(), font), font, true);
}

/// The first corner with nothing in it, else beside the data or, in a narrow panel, below it.
void place_legend(Frame& frame, const Panel& panel, double font) {
    Legend& legend = frame.legend;
    if (legend.place == Place::none) return;
    const Ink ink = ink_of(panel, frame, font);
    for (const Place place : {Place::top_right, Place::top_left, Place::bottom_right, Place::bottom_left}) {
        const Box box = corner(frame, place, font);
        if (!frame.data.holds(box) || ink.under(box) > 0) continue;
        legend.place = place;
        return;
    }
    legend.place = legend.width < 0.3 * frame.cell.width() ? Place::beside : Place::below;
    if (legend.place == Place::below) {
        const int entries = static_cast<int>(std::lround((legend.height / font - 0.6) / line_height));
        legend.columns = std::clamp(static_cast<int>(frame.cell.width() / legend.width), 1, entries);
        const int rows = (entries + legend.columns - 1) / legend.columns;
        legend.height = (rows * line_height + 0.6) * font;
    }
    fit_data(frame, panel, font);
}

Frame frame_of(const Panel& panel, const Box& cell, double font) {
    Frame frame{.cell = cell, .data = {}, .x = x_scale(panel), .y = y_scale(panel), .x_ticks = {}, .y_ticks = {},
                .legend = legend_of(panel, font), .labels = {}};
    fit_data(frame, panel, font);
    place_legend(frame, panel, font);
    Ink ink = ink_of(panel, frame, font);
    const Place place = frame.legend.place;
    if (place != Place::none && place != Place::beside && place != Place::below)
        ink.box(corner(frame, place, font), 20);
    frame.labels = place_labels(panel, frame, ink, font);
    return frame;
}

}    // namespace

double font_of(int width) { return 13 / 0.75 * std::max(1.0, width / 1000.0); }

double fitted(const std::string& text, double font, double pixels) {
    return font * std::clamp(pixels / std::max(1.0, text_width(text, font)), 0.5, 1.0);
}

std::vector<Frame> lay_out(const Chart& chart) {
    const double font = font_of(chart.width), head = chart.title.empty() ? 0 : 2.2 * font;
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
