#pragma once
#include <string>
#include <vector>

#include "sphonic/chart.hpp"

namespace sphonic::charting {

/// How a curve is drawn, in gnuplot's words.
struct Look {
    std::vector<std::string> in_plot;    ///< passes over the data, lower first: what follows the columns 1:2
    std::string in_legend;
    int layer;    ///< steps lie below the data, comparisons above
};

/// Looks of a panel's curves with widths and sizes enlarged by these factors.
std::vector<Look> looks_of(const Panel& panel, double line_scale, double marker_scale);

}    // namespace sphonic::charting
