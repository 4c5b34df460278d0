#pragma once
#include <algorithm>

#include <sphonic/error.hpp>
#include <sphonic/stability_report.hpp>

#include "scene.hpp"

namespace sphonic::testing {

/// Quick enough for tables, and exact enough for limits to 1 %: at 0.4 % beyond its limit RK4 grows by 3 % a step.
inline const StabilityTrial::Options brief{.steps = 800, .precision = 2e-3};

/// A periodic box of n particles a side, without sources and initial fields.
inline Case quiet_box(int dimension, int n, const std::vector<std::string>& set) {
    Case c = scene(periodic_box(dimension, n), set);
    silence(c);
    return c;
}

inline std::string kernel(const std::string& name, double h_over_dx) {
    return R"(/kernel={"type":")" + name + R"(","h_over_dx":)" + Json(h_over_dx).dump() + "}";
}
inline std::string integrator(const std::string& name, const std::string& more = "") {
    return R"(/integrator={"type":")" + name + R"(","unstable":"allow")" + more + "}";
}
inline std::string faces(const std::string& type) { return R"(/boundaries=[{"face":"all","type":")" + type + R"("}])"; }

/// The box sides of tables: their reach is less than half of any.
inline int side(int dimension) { return dimension == 1 ? 40 : dimension == 2 ? 24 : 10; }

}    // namespace sphonic::testing
