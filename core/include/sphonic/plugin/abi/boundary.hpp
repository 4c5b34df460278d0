#pragma once

namespace sphonic::abi {

/// What happens at a face of the box.
enum class Closure : int {
    free,        ///< nothing beyond the last particle
    periodic,    ///< the box repeats along the axis
};

class Boundary {
public:
    static constexpr const char* kind = "boundary";
    virtual ~Boundary() = default;
    virtual Closure closure() const = 0;
};

}    // namespace sphonic::abi
