#pragma once
#include <string>
#include <vector>

#include "chart_ink.hpp"
#include "chart_scale.hpp"

namespace sphonic::charting {

struct PointLabel {
    std::string text;
    Pixel point;          ///< what it names
    Box box;              ///< where it stands
    bool leader = false;  ///< too far from its point to be read without a line
};

struct Legend {
    enum class Place { none, top_right, top_left, bottom_right, bottom_left, beside, below } place = Place::none;
    int columns = 1;
    double width = 0, height = 0;    ///< [px]
    double widest = 0;               ///< entry [em]
    double longest = 0;              ///< entry [characters]
};

/// A panel with everything placed: the rectangle of its data, its axes, legend and point labels.
struct Frame {
    Box cell, data;
    Box room;    ///< what the data could have taken; a raster, whose shape is fixed, leaves some
    Box bar;     ///< of a raster's colours
    Scale x, y;
    std::vector<Tick> x_ticks, y_ticks, bar_ticks;
    Legend legend;
    std::vector<PointLabel> labels;

    bool legend_inside() const;
    Box legend_box(double gap) const;    ///< of a legend inside
    Pixel at(double px, double py) const {
        return {data.left + data.width() * x.fraction(px), data.bottom + data.height() * y.fraction(py)};
    }
};

constexpr double base_font = 13 / 0.75;    ///< 13 pt [px]
/// Font size [px]: the base for 1000 x 600 pixels, growing with the picture.
double font_of(const Chart& chart);
/// The font size that fits text into so many pixels.
double fitted(const std::string& text, double font, double pixels);

std::vector<Frame> lay_out(const Chart& chart);

/// Of ticks outside the data [px]: over a raster they would be lost.
inline double tick_length(const Panel& panel, double font) { return panel.raster ? 0.5 * font : 0; }
/// Room [px] that the colour bar, its ticks and its label take beside the data, whose height is known.
double bar_room(Frame& frame, const Raster& raster, double font);
/// Makes a unit as long on both axes and places the colour bar.
void fit_raster(Frame& frame, const Raster& raster, double font);

Ink ink_of(const Panel& panel, const Frame& frame, double font);
std::vector<PointLabel> place_labels(const Panel& panel, const Frame& frame, const Ink& ink, double font);
bool has_markers(const Curve& curve);
/// Marker size as a multiple of gnuplot's: the more points, the smaller.
double marker_size(const Curve& curve);

}    // namespace sphonic::charting
