#include "chart_script.hpp"

#include <charconv>
#include <sstream>

namespace sphonic::charting {

std::string number(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'') out += "''";
        else out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out + "'";
}

std::string data_block(std::size_t panel, std::size_t curve) {
    return "$panel" + std::to_string(panel) + "_" + std::to_string(curve);
}

void Pen::text(const std::string& text, Pixel centre, double size, double room, const std::string& style,
               const std::string& options) const {
    if (text.empty()) return;
    out << "set label " << quoted(text) << " at " << at(centre) << " center noenhanced " << options
        << " font 'DejaVu Sans" << style << "," << number(0.75 * fitted(text, size, room)) << "'\n";
}

void Pen::margins(const Box& data) const {
    out << "set lmargin at screen " << number(data.left / width_) << "\nset rmargin at screen "
        << number(data.right / width_) << "\nset bmargin at screen " << number(data.bottom / height_)
        << "\nset tmargin at screen " << number(data.top / height_) << "\n";
}

namespace {

void write_data(std::ostream& out, const Curve& curve, const Frame& frame, const std::string& name) {
    out << name << " << END\n";
    bool broken = true;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const bool shown = frame.x.shows(curve.x[i]) && frame.y.shows(curve.y[i]);
        if (shown) out << number(curve.x[i]) << " " << number(curve.y[i]) << "\n";
        else if (!broken) out << "\n";
        broken = !shown;
    }
    out << "END\n";
}

void write_picture(const Pen& pen, const Terminal& terminal, const Chart& chart, const std::vector<Frame>& frames,
                   const std::filesystem::path& file) {
    pen.out << "set terminal " << terminal.name << " size " << chart.width << "," << chart.height
            << " font 'DejaVu Sans," << number(0.75 * pen.font) << "' fontscale " << number(terminal.font)
            << " background rgb '#ffffff'\nset output " << quoted(file.string()) << "\nset multiplot\n";
    for (std::size_t p = 0; p < frames.size(); ++p) {
        pen.out << "reset\n";
        if (p == 0)
            pen.text(chart.title, {chart.width / 2.0, chart.height - 1.3 * pen.font}, 1.3 * pen.font,
                     0.9 * chart.width, ":Bold");
        write_panel(pen, terminal, chart.panels[p], frames[p], p);
    }
    pen.out << "unset multiplot\nunset output\n";
}

}    // namespace

std::string script(const Chart& chart, const std::filesystem::path& png, const std::filesystem::path& svg) {
    const std::vector<Frame> frames = lay_out(chart);
    std::ostringstream out;
    const Pen pen(chart, out);
    out << "set encoding utf8\n";
    for (std::size_t p = 0; p < frames.size(); ++p) {
        if (chart.panels[p].raster) write_cells(out, *chart.panels[p].raster, p);
        for (std::size_t c = 0; c < chart.panels[p].curves.size(); ++c)
            write_data(out, chart.panels[p].curves[c], frames[p], data_block(p, c));
    }
    write_picture(pen, {"pngcairo", 1, 0.625, 1}, chart, frames, png);
    write_picture(pen, {"svg", 1 / 0.75, 0.5236, 0.65}, chart, frames, svg);
    return out.str();
}

}    // namespace sphonic::charting
