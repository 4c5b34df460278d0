#pragma once
#include <cstdint>

namespace sphonic::abi {

/// The box that an arrangement fills. Periodic axes exclude `upper`, the others include it.
struct Box {
    int dimension = 1;
    double dx = 0;                  ///< spacing [m]
    double lower[3] = {0, 0, 0};    ///< [m]
    double upper[3] = {0, 0, 0};    ///< [m]
    bool periodic[3] = {false, false, false};
    long count[3] = {1, 1, 1};    ///< sites per axis of a lattice of this spacing
};

/// Where the particles of a set lie. The runtime owns the box; an arrangement fills in positions, x fastest.
class Arrangement {
public:
    static constexpr const char* kind = "arrangement";
    virtual ~Arrangement() = default;

    /// Called before `prepare` with the case's seed, for an arrangement with chance in it.
    virtual void seed(std::int64_t) {}
    /// Called once before anything else; throws std::invalid_argument with a remedy if it cannot fill the box.
    virtual void prepare(const Box&) {}
    /// True when the sites are exactly x = lower + i dx: frozen sets then run as a stencil.
    virtual bool regular() const = 0;
    virtual long size(const Box& box) const = 0;
    /// Volume that each particle stands for [m^d].
    virtual double volume(const Box& box) const {
        double v = 1;
        for (int a = 0; a < box.dimension; ++a) v *= box.dx;
        return v;
    }
    /// Coordinate a of particle i goes to x[a][i].
    virtual void place(const Box& box, double* const x[3]) const = 0;
};

}    // namespace sphonic::abi
