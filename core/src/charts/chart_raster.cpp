#include <array>
#include <cmath>

#include "chart_script.hpp"
#include "sphonic/error.hpp"

namespace sphonic::charting {

namespace {

/// ColorBrewer RdBu (Brewer 2002), reversed: told apart in every common colour blindness, and in grey by its dark ends.
constexpr std::array colours{"#053061", "#2166ac", "#4393c3", "#92c5de", "#d1e5f0", "#f7f7f7",
                             "#fddbc7", "#f4a582", "#d6604d", "#b2182b", "#67001f"};
constexpr const char* empty = "#c4c4c4";
constexpr int levels = 1000;    ///< of the data on each side of zero
constexpr int most_ticks = 12;  ///< upwards
constexpr double bar_gap = 1, bar_width = 0.9, tick_gap = 1.2, least_bar = 10;    ///< of the colour bar [em]
constexpr double least_ticks = 4.4;    ///< width kept for its ticks, so that panels side by side agree [em]

std::string block(std::size_t panel) { return "$raster" + std::to_string(panel); }

Scale scale_of(const Raster& raster) { return {-raster.limit, raster.limit, false}; }

std::vector<Tick> upright_ticks(const Scale& scale, double length, double font) {
    return ticks_of(scale, length, std::max(font, 0.5 * length / most_ticks), false);
}

}    // namespace

void check(const Panel& panel, const std::string& place) {
    const Raster& r = *panel.raster;
    const auto cells = static_cast<std::size_t>(std::max(r.columns, 0)) * static_cast<std::size_t>(std::max(r.rows, 0));
    if (cells == 0 || cells != r.values.size())
        throw Error(Fault::input, place + ", raster \"" + r.label + "\"",
                    std::to_string(r.values.size()) + " values for " + std::to_string(r.columns) + " x " +
                        std::to_string(r.rows) + " cells",
                    "Give one value per cell");
    for (const double length : {r.cell_width, r.cell_height, r.limit})
        if (!std::isfinite(length) || length <= 0)
            throw Error(Fault::input, place + ", raster \"" + r.label + "\"",
                        "a cell's size or the limit is " + std::to_string(length), "Give positive finite ones");
    if (panel.x.log || panel.y.log)
        throw Error(Fault::input, place + ", raster \"" + r.label + "\"", "its axes are logarithmic",
                    "Use linear axes");
}

double bar_room(Frame& frame, const Raster& raster, double font) {
    frame.bar_ticks = upright_ticks(scale_of(raster), std::max(frame.data.height(), least_bar * font), font);
    const double ticks = std::max(least_ticks * font, widest(frame.bar_ticks, font));
    return (bar_gap + bar_width + tick_gap + (raster.label.empty() ? 0 : 1.8)) * font + ticks;
}

void fit_raster(Frame& frame, const Raster& raster, double font) {
    Box& d = frame.data;
    const double x = frame.x.upper - frame.x.lower, y = frame.y.upper - frame.y.lower;
    const double unit = std::max(1 / std::max(x, y), std::min(d.width() / x, d.height() / y));    // [px]
    d = d.resized(unit * x, unit * y);
    frame.y_ticks = upright_ticks(frame.y, std::max(d.height(), font), font);
    frame.bar = {d.right + bar_gap * font, d.bottom, d.right + (bar_gap + bar_width) * font, d.top};
    if (frame.bar.height() < least_bar * font) frame.bar = frame.bar.resized(bar_width * font, least_bar * font);
    frame.bar_ticks = upright_ticks(scale_of(raster), frame.bar.height(), font);
}

void write_cells(std::ostream& out, const Raster& raster, std::size_t panel) {
    out << block(panel) << " << END\n";
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        const double value = raster.values[i] / raster.limit;
        if (std::isfinite(raster.values[i])) out << std::lround(levels * std::clamp(value, -1.0, 1.0));
        else out << "NaN";
        out << ((i + 1) % static_cast<std::size_t>(raster.columns) == 0 ? '\n' : ' ');
    }
    out << "END\n";
}

void write_colours(const Pen& pen, const Panel& panel, const Frame& frame) {
    const Raster& raster = *panel.raster;
    const Box& bar = frame.bar;
    pen.out << "set palette maxcolors 0 defined (";
    for (std::size_t i = 0; i < colours.size(); ++i) pen.out << (i ? ", " : "") << i << " '" << colours[i] << "'";
    pen.out << ")\nset cbrange [" << number(-raster.limit) << ":" << number(raster.limit)
            << "] noextend\nset colorbox vertical user origin " << pen.at({bar.left, bar.bottom}) << " size "
            << pen.at({bar.width(), bar.height()}) << " front noinvert border\nset cbtics enhanced scale 0.5,0 ";
    const char* separator = "(";
    for (const Tick& tick : frame.bar_ticks) {
        pen.out << separator << quoted(tick.text) << " " << number(tick.at);
        separator = ", ";
    }
    pen.out << ")\nset object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb '" << empty
            << "' fillstyle solid noborder\n";
    const double side = bar.right + (tick_gap + 0.9) * pen.font + widest(frame.bar_ticks, pen.font);
    const double room = std::max(bar.height(), 0.8 * frame.cell.height());
    pen.text(raster.label, {side, (bar.bottom + bar.top) / 2}, pen.font, room, "", "rotate by 90");
}

std::string image_plot(const Raster& r, std::size_t panel) {
    const std::string x = number(r.left + 0.5 * r.cell_width) + "+$1*" + number(r.cell_width);
    const std::string y = number(r.bottom + 0.5 * r.cell_height) + "+$2*" + number(r.cell_height);
    const std::string value = "$3*" + number(r.limit / levels);
    return block(panel) + " matrix using (" + x + "):(" + y + "):(" + value + ") with image notitle";
}

}    // namespace sphonic::charting

namespace sphonic {

int fitting_height(const Chart& chart) {
    Chart trial = chart;
    for (int pass = 0; pass < 12; ++pass) {
        const double font = charting::font_of(trial), head = chart.title.empty() ? 0 : 2.2 * font;
        double tallest = 1;
        const auto frames = charting::lay_out(trial);
        for (const charting::Frame& f : frames) {
            const double unit = f.room.width() / (f.x.upper - f.x.lower);
            const double needed = std::max(unit * (f.y.upper - f.y.lower), charting::least_bar * font);
            tallest = std::max(tallest, f.cell.height() - f.room.height() + needed);
        }
        const double rows = std::round((trial.height - head) / frames.front().cell.height());
        const double height = std::ceil(head + rows * tallest);
        trial.height = static_cast<int>(std::clamp(height, 0.2 * chart.width, 1.25 * chart.width));
    }
    return std::max(trial.height, 300);
}

}    // namespace sphonic
