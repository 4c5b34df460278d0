#pragma once
#include <memory>

#include <sphonic/plugin/abi/arrangement.hpp>
#include <sphonic/plugin/abi/wave.hpp>

namespace sphonic::abi {

/// An expression of x, y, z, r and the case's constants, such as a shape may be given by.
class Formula {
public:
    virtual ~Formula() = default;
    virtual void evaluate(const Points& points, double* value) const = 0;
};

/// What a shape may know of the scene.
struct ShapeScene {
    Box box;
    /// Reads an expression; an error at the shape's place in the case if it cannot be read.
    std::unique_ptr<Formula> (*formula)(const void* host, const char* text) = nullptr;
    const void* host = nullptr;
};

/// A body by its surface. Whether it is solid, or what is around it, the case says.
class Shape {
public:
    static constexpr const char* kind = "shape";
    virtual ~Shape() = default;

    /// Called once before anything else; throws std::invalid_argument with a remedy if it does not fit the scene.
    virtual void prepare(const ShapeScene& scene) = 0;
    /// The distance [m] of each point from the surface, negative within the body, and, by axis, the unit vector out of the
    /// body at the surface's nearest point: x - distance * normal lies on the surface. `normal` is null beyond the dimension.
    virtual void measure(const Points& points, double* distance, double* const normal[3]) const = 0;
};

}    // namespace sphonic::abi
