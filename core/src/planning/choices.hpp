#pragma once
#include <string>
#include <vector>

#include "open_case.hpp"

namespace sphonic {

/// One way to compute a scene, at any spacing. Null where the case decides itself, or where it does not apply.
struct Choice {
    std::string family;    ///< "band_fitted", "fdtd 2", ...
    Json method, equations, kernel, integrator;
    double support = 0, finer = 1;    ///< of band_fitted: the neighbourhood [dx], and its shortest wave over the scene's
    bool single = false;              ///< precision
    bool own_spacings = false;        ///< of media, in proportion to the speed of their sound

    /// The case at a spacing [m], with nothing open; `shortest` is the scene's wavelength that must still be carried [m].
    Json apply(const OpenCase& open, double dx, double shortest) const;
    std::string name() const;    ///< with the step
};

std::vector<Choice> choices(const OpenCase& open);

}    // namespace sphonic
