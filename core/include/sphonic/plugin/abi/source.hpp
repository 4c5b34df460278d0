#pragma once
#include <sphonic/plugin/abi/arrangement.hpp>
#include <sphonic/plugin/abi/reference.hpp>

namespace sphonic::abi {

/// What a source does to the particles of its region. Membership is decided on the initial positions.
struct Action {
    bool sets_pressure = false;    ///< p, and what p is computed from, at every step
    bool sets_velocity = false;    ///< u at every step
    bool sets_velocity_at_start = false;
    bool adds = false;    ///< what `evaluate` gives is a rate that the equations gain: dp/dt [Pa/s] and du/dt [m/s^2]

    /// Such a source needs a region.
    bool sets() const { return sets_pressure || sets_velocity || sets_velocity_at_start; }
};

/// What a source may know of the scene.
struct SourceScene {
    int dimension = 1;
    Medium medium;    ///< number 0 of `media`
    Media media;
    Box box;
    const Reference* reference = nullptr;    ///< of the case, ready by the first `evaluate`; null if it has none
};

/// How a discretised set carries a steady tone, mean over directions.
struct ToneResponse {
    double wave_number = 0;    ///< of the wave that travels there [rad/m]
    double gain = 1;           ///< far amplitude of a point source there, over that in the medium
};

/// A prescribed sound field, or a prescribed supply of sound, on some of the particles.
/// `evaluate` may be called for several blocks of particles at once, from several threads.
class Source {
public:
    static constexpr const char* kind = "source";
    virtual ~Source() = default;

    virtual Action action() const = 0;
    /// Called once before anything else; throws std::invalid_argument with a remedy if the parameters do not fit the scene.
    virtual void prepare(const SourceScene& scene) = 0;
    /// Writes 1 for each point that the source can act on, else 0; the case's region is applied besides.
    virtual void reach(const Points& points, unsigned char* inside) const {
        for (int i = 0; i < points.n; ++i) inside[i] = 1;
    }
    /// Called once with the particles it acts on, at rest, and the volume of each [m^d].
    virtual void enlist(const Points&, double) {}
    /// The frequency [rad/s] of a source of one steady tone that wants to be matched to its set; 0 for all others.
    virtual double tone() const { return 0; }
    /// The highest frequency [rad/s] that it sends with a tenth or more of the amplitude of its strongest; 0 if it does not know.
    virtual double highest_frequency() const { return wave() ? wave()->omega : tone(); }
    /// Called before the first step with the set's response at `tone()`.
    virtual void match(const ToneResponse&) {}
    /// The field, or what is added to its rates, at time t [s] and the current positions; values that the source does not act on are zero.
    virtual void evaluate(double t, const Points& points, const AcousticField& out) const = 0;
    /// The plane wave this source emits, or null: references take their waves from here.
    virtual const PlaneWave* wave() const { return nullptr; }
};

}    // namespace sphonic::abi
