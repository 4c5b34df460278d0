#include <sphonic/plugin/boundary.hpp>

/// The box repeats along the axis; the upper face is the lower one.
struct Periodic final : abi::Boundary {
    abi::Closure closure() const override { return abi::Closure::periodic; }
};

SPHONIC_BOUNDARY("periodic", Periodic, "The box repeats along the axis")
