#include "chart_script.hpp"

#include <charconv>
#include <sstream>

#include "chart_frame.hpp"
#include "chart_style.hpp"

namespace sphonic::charting {

namespace {

std::string number(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// Nothing is expanded between gnuplot's single quotes; a quote is doubled, a control character would end the string.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'') out += "''";
        else out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out + "'";
}

std::string font_px(double pixels) { return "font '," + number(0.75 * pixels) + "'"; }

class Script {
public:
    explicit Script(const Chart& chart) : chart_(chart), frames_(lay_out(chart)), font_(font_of(chart.width)) {}

    std::string data() const;
    std::string body() const;

private:
    static std::string block(std::size_t panel, std::size_t curve) {
        return "$panel" + std::to_string(panel) + "_" + std::to_string(curve);
    }
    std::string at(double x, double y) const {
        return "screen " + number(x / chart_.width) + "," + number(y / chart_.height);
    }
    void title(std::ostream& out) const;
    void axes(std::ostream& out, const Panel& panel, const Frame& frame) const;
    void axis(std::ostream& out, char name, const Axis& axis, const Scale& scale, const std::vector<Tick>& ticks,
              double length) const;
    void legend(std::ostream& out, const Frame& frame) const;
    void labels(std::ostream& out, const Frame& frame) const;
    void plot(std::ostream& out, std::size_t panel) const;

    const Chart& chart_;
    const std::vector<Frame> frames_;
    const double font_;
};

std::string Script::data() const {
    std::string out;
    for (std::size_t p = 0; p < chart_.panels.size(); ++p)
        for (std::size_t c = 0; c < chart_.panels[p].curves.size(); ++c) {
            const Curve& curve = chart_.panels[p].curves[c];
            out += block(p, c) + " << END\n";
            bool broken = true;
            for (std::size_t i = 0; i < curve.x.size(); ++i) {
                const bool shown = frames_[p].x.shows(curve.x[i]) && frames_[p].y.shows(curve.y[i]);
                if (shown) out += number(curve.x[i]) + " " + number(curve.y[i]) + "\n";
                else if (!broken) out += "\n";
                broken = !shown;
            }
            out += "END\n";
        }
    return out;
}

void Script::title(std::ostream& out) const {
    const double size = fitted(chart_.title, 1.3 * font_, 0.94 * chart_.width);
    if (!chart_.title.empty())
        out << "set label " << quoted(chart_.title) << " at " << at(chart_.width / 2.0, chart_.height - 1.3 * font_)
            << " center noenhanced font 'DejaVu Sans:Bold," << number(0.75 * size) << "'\n";
}

void Script::axis(std::ostream& out, char name, const Axis& axis, const Scale& scale, const std::vector<Tick>& ticks,
                  double length) const {
    if (scale.log) out << "set logscale " << name << " 10\n";
    out << "set " << name << "range [" << number(scale.lower) << ":" << number(scale.upper) << "] noextend\n";
    out << "set " << name << "label " << quoted(axis.label) << " noenhanced "
        << font_px(fitted(axis.label, font_, length)) << "\n";
    out << "set " << name << "tics enhanced nomirror scale 0.7,0.4 (";
    const char* separator = "";
    for (const Tick& tick : ticks) {
        out << separator << quoted(tick.text) << " " << number(tick.at) << (tick.text.empty() ? " 1" : "");
        separator = ", ";
    }
    out << ")\n";
}

void Script::axes(std::ostream& out, const Panel& panel, const Frame& frame) const {
    const Box& d = frame.data;
    out << "set lmargin at screen " << number(d.left / chart_.width) << "\nset rmargin at screen "
        << number(d.right / chart_.width) << "\nset bmargin at screen " << number(d.bottom / chart_.height)
        << "\nset tmargin at screen " << number(d.top / chart_.height) << "\n";
    out << "set border 3 lc rgb '#404040' lw 1\nset grid xtics ytics lt 1 lw 0.8 lc rgb '#dddddd'\nset grid back\n";
    if (!panel.title.empty())
        out << "set label " << quoted(panel.title) << " at "
            << at((d.left + d.right) / 2, d.top + 1.1 * font_) << " center noenhanced "
            << font_px(fitted(panel.title, 1.1 * font_, frame.cell.width() - font_)) << "\n";
    axis(out, 'x', panel.x, frame.x, frame.x_ticks, frame.cell.width() - font_);
    axis(out, 'y', panel.y, frame.y, frame.y_ticks, frame.cell.height());
}

void Script::legend(std::ostream& out, const Frame& frame) const {
    const Box &d = frame.data, &cell = frame.cell;
    const double gap = 0.5 * font_;
    const std::string where[] = {"",
                                 at(d.right - gap, d.top - gap) + " right top",
                                 at(d.left + gap, d.top - gap) + " left top",
                                 at(d.right - gap, d.bottom + gap) + " right bottom",
                                 at(d.left + gap, d.bottom + gap) + " left bottom",
                                 at(d.right + gap, d.top) + " left top",
                                 at((cell.left + cell.right) / 2, cell.bottom + gap / 2) + " center bottom"};
    if (frame.legend.place == Legend::Place::none) {
        out << "unset key\n";
        return;
    }
    const bool wide = frame.legend.columns > 1;
    out << "set key at " << where[static_cast<int>(frame.legend.place)] << (wide ? " horizontal" : " vertical")
        << " maxrows auto maxcols " << frame.legend.columns
        << " Left reverse noenhanced samplen 2.5 spacing 1.15 opaque fillcolor rgb '#ffffff' box lc rgb '#c0c0c0'"
        << " lw 0.8\n";
}

void Script::labels(std::ostream& out, const Frame& frame) const {
    for (const PointLabel& label : frame.labels) {
        const Box& b = label.box;
        if (label.leader)
            out << "set arrow from " << at(label.point.x, label.point.y) << " to "
                << at(std::clamp(label.point.x, b.left, b.right), std::clamp(label.point.y, b.bottom, b.top))
                << " nohead back lw 0.9 lc rgb '#808080'\n";
        out << "set label " << quoted(label.text) << " at " << at((b.left + b.right) / 2, (b.bottom + b.top) / 2)
            << " center noenhanced front tc rgb '#202020'\n";
    }
}

void Script::plot(std::ostream& out, std::size_t panel) const {
    const Panel& drawn = chart_.panels[panel];
    const std::vector<Look> looks = looks_of(drawn, font_ / font_of(1000));
    out << "plot NaN notitle";
    for (const int layer : {0, 1, 2})
        for (std::size_t c = 0; c < looks.size(); ++c)
            if (looks[c].layer == layer)
                for (const std::string& pass : looks[c].in_plot)
                    out << ", \\\n  " << block(panel, c) << " using 1:2 " << pass << " notitle";
    for (std::size_t c = 0; c < looks.size(); ++c)
        if (!drawn.curves[c].label.empty())
            out << ", \\\n  NaN " << looks[c].in_legend << " title " << quoted(drawn.curves[c].label);
    out << "\n";
}

std::string Script::body() const {
    std::ostringstream out;
    out << "set multiplot\n";
    for (std::size_t p = 0; p < chart_.panels.size(); ++p) {
        out << "reset\n";
        if (p == 0) title(out);
        axes(out, chart_.panels[p], frames_[p]);
        legend(out, frames_[p]);
        labels(out, frames_[p]);
        plot(out, p);
    }
    out << "unset multiplot\nunset output\n";
    return out.str();
}

}    // namespace

std::string script(const Chart& chart, const std::filesystem::path& png, const std::filesystem::path& svg) {
    const Script script(chart);
    const std::string body = script.body(), size = " size " + std::to_string(chart.width) + "," +
                                                   std::to_string(chart.height);
    const std::string font = number(0.75 * font_of(chart.width)) + "'";
    return "set encoding utf8\n" + script.data() + "set terminal pngcairo" + size + " font 'DejaVu Sans," + font +
           " background rgb '#ffffff'\nset output " + quoted(png.string()) + "\n" + body + "set terminal svg" + size +
           " font 'DejaVu Sans," + font + " fontscale 1.333333 background rgb '#ffffff'\nset output " +
           quoted(svg.string()) + "\n" + body;
}

}    // namespace sphonic::charting
