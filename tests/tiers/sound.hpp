#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../support/scene.hpp"

namespace sphonic::testing {

inline const std::string viscosity = R"(/viscosity={"type":"monaghan","alpha":0.5,"beta":0.5})";

/// A sound without symmetry, resolved by some ten particles.
inline std::vector<std::string> sound(int dimension) {
    const std::string y = dimension > 1 ? "*cos(2*pi*y)" : "", z = dimension > 2 ? "*cos(2*pi*z)" : "";
    std::string u = R"("0.1*sin(2*pi*x))" + y + z + "\"";
    for (int a = 1; a < dimension; ++a) u += R"(,"0.05*cos(4*pi*x))" + y + "\"";
    return {"/initial/p=exp(sin(2*pi*x))" + y + z, "/initial/u=[" + u + "]"};
}

/// The case of `sound` in a box of n particles per unit length, with settings.
inline Case sounding(int dimension, int n, const std::vector<std::string>& set) {
    std::vector<std::string> all = sound(dimension);
    all.insert(all.end(), set.begin(), set.end());
    return scene(periodic_box(dimension, n), all);
}

inline Profile final_state(int dimension, int n, const std::vector<std::string>& set) {
    const Case c = sounding(dimension, n, set);
    Simulation simulation(c);
    simulation.run();
    return simulation.profile();
}

inline double largest_difference(const Profile& a, const Profile& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.p.size(); ++i) worst = std::max(worst, std::abs(a.p[i] - b.p[i]));
    return worst;
}

/// Linear acoustics with these forms of divergence and gradient.
inline std::string forms(const std::string& divergence, const std::string& gradient) {
    return R"(/equations={"p":[{"divergence":"u","form":")" + divergence + R"(","times":"-rho0*c0^2"}],"u":[{"gradient":"p","form":")" +
           gradient + R"(","times":"-1/rho0"}]})";
}

/// Corrected forms in volumes of the current density.
inline const std::string current_density = R"(/equations={
    "drho":[{"divergence":"u","form":"corrected","times":"-rho"}],"rho":{"state":"total_density","of":"drho"},
    "p":{"state":"acoustic","of":"drho"},"u":[{"gradient":"p","form":"corrected_adjoint","times":"-1/rho"}]})";

/// A boundary for a setting of /boundaries.
inline std::string face(const std::string& name, const std::string& type, const std::string& place = "") {
    return R"({"face":")" + name + R"(","type":")" + type + (place.empty() ? "" : R"(","wall":")" + place) + "\"}";
}

}    // namespace sphonic::testing
