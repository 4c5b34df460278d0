#pragma once
#include <sphonic/plugin/abi/wave.hpp>

namespace sphonic::abi {

/// What a source fixes on the particles of its region. Membership is decided on the initial positions.
struct Imposed {
    bool pressure_each_step = true;    ///< p and what p is computed from (drho)
    bool velocity_each_step = false;
    bool velocity_at_start = true;    ///< u once, then free
};

/// A prescribed sound field on a region of the set.
class Source {
public:
    static constexpr const char* kind = "source";
    virtual ~Source() = default;

    /// Called once before anything else; throws std::invalid_argument with a remedy if the parameters do not fit the dimension.
    virtual void prepare(int dimension, const Medium& medium) = 0;
    virtual Imposed imposed() const = 0;
    /// The field at time t [s] and the current positions.
    virtual void evaluate(double t, const Points& points, const AcousticField& out) const = 0;
    /// The plane wave this source emits, or null: references take their waves from here.
    virtual const PlaneWave* wave() const = 0;
};

}    // namespace sphonic::abi
