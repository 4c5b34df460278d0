#pragma once
#include <optional>
#include <string>
#include <vector>

#include <sphonic/plan.hpp>
#include <sphonic/stretch.hpp>

namespace sphonic {

/// A case before it is planned: what it leaves open is taken out of the document.
struct OpenCase {
    Json document;
    std::string file;
    bool method = false, equations = false, kernel = false, spacing = false, step = false, integrator = false, viscosity = false;
    bool motion = false, active = false;    ///< given otherwise than a plan has them
    bool attenuation = false;    ///< of absorbing layers
    bool precision = false;
    bool own_spacings = false;    ///< media may have spacings of their own, where the box has one dimension
    std::vector<Stratum> strata;  ///< of such a box

    bool anything() const { return method || equations || kernel || spacing || step; }
    int dimension() const { return document["dimension"]; }
    /// Length of the box along an axis [m].
    double length(int axis) const;
    /// True if both faces, or their images, must lie a whole number of spacings apart.
    bool whole(int axis) const;
};

bool several_media(const OpenCase& open);
/// Particles that do not lie on the sites of a lattice.
bool off_sites(const OpenCase& open);
/// Particles that are no whole lattice.
bool displaced(const OpenCase& open);
/// Of the sound in a medium of a document [m/s].
double speed(const Json& medium);

/// Errors stand at the members that planning needs: /dimension, and /particles with lower and upper.
OpenCase opened(const Json& document, const std::string& file, bool free);

/// Drops the axes along which nothing of a case changes: periodic or rigid on both sides, no obstacle, no source, wave or expression
/// that knows of them. Expressions are renamed where an axis moves up.
std::vector<Decision> drop_axes(Json& document);

}    // namespace sphonic
