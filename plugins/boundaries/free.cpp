#include <sphonic/plugin/boundary.hpp>

/// The set simply ends: sums run over the particles that exist.
struct Free final : abi::Boundary {
    abi::Closure closure() const override { return abi::Closure::free; }
};

SPHONIC_BOUNDARY("free", Free, "Nothing beyond the last particle (the default)")
