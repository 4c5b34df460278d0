#pragma once
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <sphonic/case.hpp>
#include <sphonic/json.hpp>
#include <sphonic/registry.hpp>
#include <sphonic/simulation.hpp>

namespace sphonic::testing {

inline const double pi = std::acos(-1.0);

inline Registry& registry() {
    static Registry instance(Registry::search_path());
    return instance;
}

/// A case from JSON text, with overrides.
inline Case scene(const std::string& text, const std::vector<std::string>& set = {}) {
    Json document = parse_json(text, "test.json");
    for (const auto& assignment : set) set_at(document, assignment);
    return load_case(std::move(document), SPHONIC_SOURCE_DIR "/cases/test/test.json", registry());
}

/// A case of the repository, such as "li2015/propagation", with overrides.
inline Case repository_case(const std::string& name, const std::vector<std::string>& set = {}) {
    return load_case(SPHONIC_SOURCE_DIR "/cases/" + name + ".json", set, registry());
}

inline Summary run(const Case& c) {
    Simulation simulation(c);
    simulation.run();
    return simulation.summary();
}

/// Linear sound in a periodic box of n particles per unit length and axis; the first axis is `length` long.
inline std::string periodic_box(int dimension, int n, double length = 1) {
    std::string lower = "0", upper = std::to_string(length), at_rest = "\"0\"";
    for (int a = 1; a < dimension; ++a) {
        lower += ",0";
        upper += ",1";
        at_rest += ",\"0\"";
    }
    return R"({"dimension": )" + std::to_string(dimension) + R"(, "medium": {"c0": 2, "rho0": 1.5},
        "particles": {"type": "lattice", "dx": )" + Json(1.0 / n).dump() + R"(, "lower": [)" + lower + R"(], "upper": [)" + upper +
           R"(]}, "kernel": {"type": "cubic_spline", "h_over_dx": 1}, "equations": "linear_acoustics",
        "boundaries": [{"type": "periodic", "face": "all"}], "initial": {"p": "0", "u": [)" + at_rest + R"(]},
        "integrator": {"type": "velocity_verlet", "courant": 0.5}, "until": 0.25})";
}

/// Relative L2 distance of the present pressure from `exact(x)`.
template <class Exact>
double pressure_error(Simulation& simulation, Exact exact) {
    const Profile now = simulation.profile();
    double squares = 0, norm = 0;
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        const double p = exact(now.x[0][i]);
        squares += (now.p[i] - p) * (now.p[i] - p);
        norm += p * p;
    }
    return std::sqrt(squares / norm);
}

}    // namespace sphonic::testing
