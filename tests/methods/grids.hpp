#pragma once
/// Scenes for methods that run on grids of their own.
#include "../support/cloud.hpp"
#include "../support/waves.hpp"

namespace sphonic::testing {

inline const std::string fdtd = R"(/method={"type":"fdtd"})", fdtd_4 = R"(/method={"type":"fdtd","order":4})", kspace = R"(/method={"type":"kspace"})";

/// Pressure without any order, down to the shortest waves.
inline std::string noise(int dimension) {
    return std::string("sin(1e4*sin(3e3*x + 1") + (dimension > 1 ? " + 7e3*y^2" : "") + (dimension > 2 ? " + 5e3*z^3" : "") + "))";
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
    return worst;
}

inline std::string face(const std::string& where, const std::string& type, const std::string& wall = "") {
    return R"({"face":")" + where + R"(","type":")" + type + '"' + (wall.empty() ? "" : R"(,"wall":")" + wall + '"') + "}";
}

}    // namespace sphonic::testing
