#pragma once
#include <sphonic/plugin/abi/media.hpp>

namespace sphonic::abi {

/// What a reference solution may know of the scene.
struct ReferenceScene {
    int dimension = 1;
    Medium medium;                      ///< number 0 of `media`
    Media media;
    const PlaneWave* waves = nullptr;    ///< those of the sources, in their order
    int wave_count = 0;
};

/// An exact solution, against which a run is measured.
class Reference {
public:
    static constexpr const char* kind = "reference";
    virtual ~Reference() = default;

    /// True for one that knows of several media; the others are refused where a scene has them.
    virtual bool several_media() const { return false; }

    /// Called once; throws std::invalid_argument with a remedy if the scene does not fit.
    virtual void prepare(const ReferenceScene& scene) = 0;
    virtual void evaluate(double t, const Points& points, const AcousticField& out) const = 0;
};

}    // namespace sphonic::abi
