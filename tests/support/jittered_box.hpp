#pragma once
#include <optional>

#include "scene.hpp"

namespace sphonic::testing {

/// Relative L2 error of the mode cos 2 pi x cos pi y of a rigid box of length L after t = L/c0, on n x n particles displaced by up to
/// dx/5, by corrected forms with dissipation: of strength `alpha`, or the usual one.
inline double jittered_box_error(int n, std::optional<double> alpha = {}) {
    std::vector<std::string> set{"/particles/dx=" + Json(1.0 / n).dump(), R"(/integrator={"type":"velocity_verlet","courant":0.4})",
                                 "/until=" + Json(1.0 / 340).dump()};
    if (alpha) set.push_back("/dissipation/alpha=" + Json(*alpha).dump());
    const Case c = repository_case("scenes/jittered_box", set);
    const Summary s = run(c);
    CHECK(c.jitter == 0.2);
    CHECK_FALSE(s.diverged);
    return s.errors.value().l2;
}

}    // namespace sphonic::testing
