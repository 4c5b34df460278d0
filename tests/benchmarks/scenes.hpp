#pragma once
#include <string>
#include <vector>

#include <sphonic/case.hpp>
#include <sphonic/json.hpp>
#include <sphonic/registry.hpp>

#include "stencil.hpp"

namespace sphonic::benchmarks {

/// Linear sound on a lattice of n^d particles in a bounded box of unit spacing.
inline Case lattice(int dimension, int n, double h_over_dx, const std::vector<std::string>& set = {}) {
    static Registry registry(Registry::search_path());
    Json lower = Json::array(), upper = Json::array();
    for (int a = 0; a < dimension; ++a) {
        lower.push_back(0);
        upper.push_back(n - 1);
    }
    Json document{{"dimension", dimension},
                  {"medium", {{"c0", 1}, {"rho0", 1}}},
                  {"particles", {{"type", "lattice"}, {"dx", 1}, {"lower", lower}, {"upper", upper}}},
                  {"kernel", {{"type", "cubic_spline"}, {"h_over_dx", h_over_dx}}},
                  {"equations", "linear_acoustics"},
                  {"initial", {{"p", "1e-6*sin(x/7)"}}},
                  {"integrator", {{"type", "symplectic_euler"}, {"courant", 0.1}}},
                  {"until", 1e9}};
    for (const std::string& assignment : set) set_at(document, assignment);
    Case scene = load_case(std::move(document), SPHONIC_SOURCE_DIR "/cases/benchmark/lattice.json", registry);
    scene.threads = 1;
    return scene;
}

inline const std::string monaghan = R"(/viscosity={"type":"monaghan","alpha":0.06,"beta":0.5})";

/// Of the first kernel's gradient: those of a lattice pair and of its mirror images along x and across it are the same but for signs.
inline double distinct_weights(const Case& scene) {
    double count = 0;
    for (const Offset& n : half_neighbours(lattice_neighbours(scene.box, scene.kernels[0])))
        for (int a = 0; a < scene.box.dimension; ++a) count += n.o[a] == 0 ? 0 : n.o[0] == 0 || (n.o[1] == 0 && n.o[2] == 0) ? 1 : 0.5;
    return count;
}

}    // namespace sphonic::benchmarks
