#pragma once
#include "scene.hpp"

/// Boxes of displaced particles with forms that fit their weights.
namespace sphonic::testing {

constexpr double c0 = 2, rho0 = 1.5;    ///< of periodic_box

inline std::string number(double x) { return Json(x).dump(); }

/// A box of n particles per axis, displaced by up to `jitter` spacings, with fitted forms.
inline std::vector<std::string> cloud(double jitter, int seed) {
    return {"/equations=band_fitted_acoustics", "/particles/jitter=" + number(jitter), "/particles/seed=" + std::to_string(seed), "/particles/neighbours=frozen"};
}

inline std::vector<std::string> with(std::vector<std::string> all, const std::vector<std::string>& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// Energy after `steps` steps from noise that all modes take part in, over that at the start.
inline double growth(int dimension, int n, double steps, double courant, const std::vector<std::string>& set) {
    std::string p = "sin(12345.6*x)", u = "\"sin(7777.7*x)\"";
    if (dimension > 1) p = "sin(12345.6*x+9876.5*y)*cos(5432.1*x-8765.4*y)", u = "\"sin(7777.7*x+3333.3*y)\",\"cos(4444.4*x+2222.2*y)\"";
    if (dimension > 2) p += "*cos(3456.7*z+x)", u += ",\"sin(6543.2*z+y)\"";
    const Case c = scene(periodic_box(dimension, n), with(set, {"/initial={\"p\":\"" + p + "\",\"u\":[" + u + "]}", "/integrator/courant=" + number(courant),
                                                                "/until=" + number(steps * courant / (n * c0))}));
    const Summary s = run(c);
    return s.energy_final / s.energy_initial;
}

}    // namespace sphonic::testing
