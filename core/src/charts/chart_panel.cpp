#include <algorithm>
#include <array>

#include "chart_script.hpp"
#include "chart_style.hpp"

namespace sphonic::charting {

namespace {

void write_axis(const Pen& pen, char name, const Scale& scale, const std::vector<Tick>& ticks) {
    if (scale.log) pen.out << "set logscale " << name << " 10\n";
    pen.out << "set " << name << "range [" << number(scale.lower) << ":" << number(scale.upper) << "] noextend\nset "
            << name << "tics enhanced nomirror scale 0.7,0.4 " << (name == 'x' ? "offset 0,-0.2 " : "");
    const char* separator = "(";
    for (const Tick& tick : ticks) {
        pen.out << separator << quoted(tick.text) << " " << number(tick.at) << (tick.text.empty() ? " 1" : "");
        separator = ", ";
    }
    pen.out << (ticks.empty() ? "()\n" : ")\n");
}

void write_axes(const Pen& pen, const Panel& panel, const Frame& frame) {
    const Box &d = frame.data, &cell = frame.cell;
    const double font = pen.font, outside = tick_length(panel, font), middle = (d.left + d.right) / 2;
    const double beside = d.left - widest(frame.y_ticks, font) - 1.9 * font - outside;
    pen.margins(d);
    pen.out << (panel.raster ? "set tics out\nset border 15" : "set border 3")
            << " lc rgb '#404040' lw 1\nset grid xtics ytics lt 1 lw 0.8 lc rgb '#dddddd'\nset grid back\n";
    write_axis(pen, 'x', frame.x, frame.x_ticks);
    write_axis(pen, 'y', frame.y, frame.y_ticks);
    pen.text(panel.title, {middle, d.top + 1.1 * font}, 1.1 * font, cell.width() - font);
    pen.text(panel.x.label, {middle, d.bottom - 2.9 * font - outside}, font, cell.width() - font);
    pen.text(panel.y.label, {beside, (d.bottom + d.top) / 2}, font, cell.height() - font, "", "rotate by 90");
}

void write_legend(const Pen& pen, const Frame& frame, double letter) {
    const Box& d = frame.data;
    const Legend& legend = frame.legend;
    const double gap = 0.5 * pen.font;
    if (legend.place == Legend::Place::none) {
        pen.out << "unset key\n";
        return;
    }
    const std::array<std::pair<Pixel, const char*>, 7> spots{
        {{{}, ""},
         {{d.right - gap, d.top - gap}, " right top"},
         {{d.left + gap, d.top - gap}, " left top"},
         {{d.right - gap, d.bottom + gap}, " right bottom"},
         {{d.left + gap, d.bottom + gap}, " left bottom"},
         {{d.right + gap, d.top}, " left top"},
         {{(d.left + d.right) / 2, frame.cell.bottom + gap / 2}, " center bottom"}}};
    const auto& [point, anchor] = spots[static_cast<std::size_t>(legend.place)];
    pen.out << "set key at " << pen.at(point) << anchor << (legend.columns > 1 ? " horizontal" : " vertical")
            << " maxrows auto maxcols " << legend.columns << " Left reverse noenhanced samplen 2.5 spacing 1.15"
            << " height 0.4 width " << number((legend.widest + 0.6) / letter - legend.longest)
            << " opaque fillcolor rgb '#ffffff' box lc rgb '#c0c0c0' lw 0.8\n";
}

void write_labels(const Pen& pen, const Frame& frame) {
    for (const PointLabel& label : frame.labels) {
        const Box& b = label.box;
        const Pixel end{std::clamp(label.point.x, b.left, b.right), std::clamp(label.point.y, b.bottom, b.top)};
        if (label.leader)
            pen.out << "set arrow from " << pen.at(label.point) << " to " << pen.at(end)
                    << " nohead back lw 0.9 lc rgb '#808080'\n";
        pen.text(label.text, {(b.left + b.right) / 2, (b.bottom + b.top) / 2}, pen.font, frame.cell.width(), "",
                 "front tc rgb '#202020'");
    }
}

/// The legend's entries come from empty plots, so that they keep the order given whatever lies above what.
void write_curves(const Pen& pen, const Panel& panel, std::size_t index, double marker) {
    const double scale = pen.font / base_font;
    const std::vector<Look> looks = looks_of(panel, scale, marker * scale);
    pen.out << "plot " << (panel.raster ? image_plot(*panel.raster, index) : "NaN notitle");
    for (const int layer : {0, 1, 2})
        for (std::size_t c = 0; c < looks.size(); ++c)
            if (looks[c].layer == layer)
                for (const std::string& pass : looks[c].in_plot)
                    pen.out << ", \\\n  " << data_block(index, c) << " using 1:2" << pass << " notitle";
    for (std::size_t c = 0; c < looks.size(); ++c)
        if (!panel.curves[c].label.empty())
            pen.out << ", \\\n  NaN " << looks[c].in_legend << " title " << quoted(panel.curves[c].label);
    pen.out << "\n";
}

}    // namespace

void write_panel(const Pen& pen, const Terminal& terminal, const Panel& panel, const Frame& frame, std::size_t index) {
    write_axes(pen, panel, frame);
    if (panel.raster) write_colours(pen, panel, frame);
    write_legend(pen, frame, terminal.letter);
    write_labels(pen, frame);
    write_curves(pen, panel, index, terminal.marker);
}

}    // namespace sphonic::charting
