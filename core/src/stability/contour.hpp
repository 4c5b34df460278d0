#pragma once
#include <functional>
#include <vector>

namespace sphonic {

/// Lines in a plane; a NaN parts one from the next.
struct Lines {
    std::vector<double> x, y;
};

/// Where values on the crossings of a grid change sign, by marching squares: `value` row by row, x fastest. Between two crossings
/// they are taken as linear, or the place is found by bisecting `exact`.
Lines zero_lines(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& value,
                 const std::function<double(double x, double y)>& exact = {});

}    // namespace sphonic
