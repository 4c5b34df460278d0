#include "chart_style.hpp"

#include <array>
#include <map>
#include <sstream>

#include "chart_frame.hpp"

namespace sphonic::charting {

namespace {

using Style = Curve::Style;

/// Okabe and Ito (2008) without yellow, which is lost on white.
constexpr std::array palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#666666"};
constexpr std::array full_markers{7, 5, 9, 13, 11, 15};
constexpr std::array hollow_markers{6, 4, 8, 12, 10, 14};
constexpr std::array dashes{"solid", "(14,4,3,4)", "(3,4)"};
constexpr std::array comparison_dashes{"(9,6)", "(2,4)", "(9,5,2,5)"};

template <class List> auto cycled(const List& list, std::size_t i) { return list[i % list.size()]; }

struct Rank {
    std::size_t colour;    ///< family, or position among the coloured curves
    std::size_t member;    ///< how many before it have this colour, and are dashed if it is
};

std::string line_of(const Curve& curve, Rank rank, double scale) {
    const bool comparison = curve.style == Style::dashed;
    const char* colour = comparison && curve.family < 0 ? "#000000" : cycled(palette, rank.colour);
    if (curve.style == Style::steps) colour = "#555555";
    const char* dash = comparison ? cycled(comparison_dashes, rank.member) : cycled(dashes, rank.member);
    std::ostringstream out;
    out << " lc rgb '" << colour << "' lw " << (comparison ? 2 : curve.style == Style::points ? 1.5 : 2.2) * scale
        << " dt " << (curve.style == Style::points ? "solid" : dash);
    return out.str();
}

std::string marker_of(const Curve& curve, Rank rank, double size) {
    const bool hollow = rank.member % 2 == 1;
    int marker = hollow ? cycled(hollow_markers, rank.colour) : cycled(full_markers, rank.colour);
    if (curve.style == Style::steps) {
        marker = 6;
        size *= 1.9;
    } else if (marker >= 8) {
        size *= 1.25;
    }
    std::ostringstream out;
    out << " pt " << marker << " ps " << size;
    return out.str();
}

/// Light, so that lines over them are seen.
constexpr std::array cell_colours{"#cfe6f5", "#fbe3a9", "#f2b8a6"};

Look cells_of(const Curve& curve) {
    std::ostringstream size;
    size << ":(" << curve.cell_width / 2 << "):(" << curve.cell_height / 2 << ")";
    const std::string colour = curve.colour.empty() ? cycled(cell_colours, static_cast<std::size_t>(std::max(0, curve.family))) : curve.colour;
    return {{size.str() + " with boxxyerror lc rgb '" + colour + "' fillstyle solid"}, "with boxes lc rgb '" + colour + "' fillstyle solid", 0};
}

Look look_of(const Curve& curve, Rank rank, double line_scale, double marker_scale) {
    if (curve.style == Style::cells) return cells_of(curve);
    const std::string line = line_of(curve, rank, line_scale);
    const std::string marker = marker_of(curve, rank, marker_scale * marker_size(curve));
    const std::string legend = line + marker_of(curve, rank, marker_scale * 1.3);
    switch (curve.style) {
        case Style::points: return {{" with points" + line + marker}, "with points" + legend, 1};
        case Style::line_points: return {{" with linespoints" + line + marker}, "with linespoints" + legend, 1};
        case Style::steps:
            return {{" with steps" + line, " with points" + line + marker}, "with linespoints" + legend, 0};
        case Style::dashed: return {{" with lines" + line}, "with lines" + line, 2};
        default: return {{" with lines" + line}, "with lines" + line, 1};
    }
}

}    // namespace

std::vector<Look> looks_of(const Panel& panel, double line_scale, double marker_scale) {
    std::vector<Look> looks;
    std::map<std::pair<int, bool>, std::size_t> members;    // by colour, those for comparison apart
    std::size_t position = 0;
    for (const Curve& curve : panel.curves) {
        const bool neutral = curve.family < 0 && (curve.style == Style::dashed || curve.style == Style::steps);
        const std::size_t colour = curve.family < 0 ? position : static_cast<std::size_t>(curve.family);
        if (!neutral) ++position;
        const int group = neutral ? -1 - static_cast<int>(curve.style) : static_cast<int>(colour % palette.size());
        looks.push_back(look_of(curve, {colour, members[{group, curve.style == Style::dashed}]++}, line_scale, marker_scale));
    }
    return looks;
}

}    // namespace sphonic::charting
