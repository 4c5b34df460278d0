#pragma once
#include <filesystem>
#include <ostream>
#include <string>

#include "chart_frame.hpp"

namespace sphonic::charting {

/// Where gnuplot's terminals differ although the picture should not.
struct Terminal {
    std::string name;
    double font;      ///< factor to the font sizes
    double letter;    ///< width that the legend reserves for a character [em]
    double marker;    ///< factor to the marker sizes
};

std::string number(double value);
/// Nothing is expanded between gnuplot's single quotes; a quote is doubled, a control character becomes a space.
std::string quoted(const std::string& text);
std::string data_block(std::size_t panel, std::size_t curve);

/// Writes gnuplot's commands in pixels of the picture.
class Pen {
public:
    Pen(const Chart& chart, std::ostream& out)
        : font(font_of(chart)), out(out), width_(chart.width), height_(chart.height) {}

    std::string at(Pixel p) const { return "screen " + number(p.x / width_) + "," + number(p.y / height_); }
    /// Text around a point, made smaller where it does not fit into `room` [px].
    void text(const std::string& text, Pixel centre, double size, double room, const std::string& style = "",
              const std::string& options = "") const;
    void margins(const Box& data) const;

    const double font;    ///< [px]
    std::ostream& out;

private:
    const double width_, height_;
};

/// Axes, legend, labels and curves of one panel.
void write_panel(const Pen& pen, const Terminal& terminal, const Panel& panel, const Frame& frame, std::size_t index);

/// Throws where a raster cannot be drawn; `place` names the chart.
void check(const Panel& panel, const std::string& place);
/// Data of a raster: its values in units of the limit, in thousandths.
void write_cells(std::ostream& out, const Raster& raster, std::size_t panel);
/// Colours, their bar and what lies behind the cells.
void write_colours(const Pen& pen, const Panel& panel, const Frame& frame);
/// The part of a plot command that draws the cells.
std::string image_plot(const Raster& raster, std::size_t panel);

/// A complete script, data inside, that writes the picture to both files.
std::string script(const Chart& chart, const std::filesystem::path& png, const std::filesystem::path& svg);

}    // namespace sphonic::charting
