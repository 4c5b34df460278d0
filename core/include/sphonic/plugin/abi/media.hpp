#pragma once
#include <sphonic/plugin/abi/wave.hpp>

namespace sphonic::abi {

/// The media of a scene by number: 0 fills the box but for the regions that have another.
struct Media {
    const Medium* medium = nullptr;
    int count = 0;
    /// Writes each point's number.
    void (*find)(const void* host, const Points& points, int* number) = nullptr;
    const void* host = nullptr;
    const double* spacing = nullptr;    ///< of the particles, by number [m]; null: the box's everywhere

    /// The medium at a point of `dimension` coordinates; `otherwise` if there are not several.
    const Medium& at(int dimension, const double* x, const Medium& otherwise) const {
        return count < 2 ? otherwise : medium[number_at(dimension, x)];
    }
    /// Spacing of the particles at a point; `otherwise` if no medium has one of its own.
    double spacing_at(int dimension, const double* x, double otherwise) const { return spacing ? spacing[number_at(dimension, x)] : otherwise; }
    int number_at(int dimension, const double* x) const {
        Points one{.dimension = dimension, .n = 1};
        for (int a = 0; a < dimension; ++a) one.x[a] = x + a;
        int number = 0;
        find(host, one, &number);
        return number;
    }
};

}    // namespace sphonic::abi
