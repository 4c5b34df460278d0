#include <sphonic/plugin/boundary.hpp>

/// p = 0 by mirror images: p and tangential u odd, normal u even.
struct Soft final : abi::Boundary {
    std::string wall = "on_particles";

    static constexpr auto parameters() {
        return std::array{text("wall", &Soft::wall, "on_particles|half_way", "where it lies: on the last particles, or half a spacing beyond")};
    }
    abi::Closure closure() const override { return abi::Closure::mirror; }
    bool half_way() const override { return wall == "half_way"; }
    int parity(abi::Part part) const override { return part == abi::Part::normal ? 1 : -1; }
};

SPHONIC_BOUNDARY("soft", Soft, "A pressure-release surface: no sound pressure on it")
