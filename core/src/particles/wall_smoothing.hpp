#pragma once
#include <cstdint>
#include <vector>

#include <sphonic/case.hpp>

#include "sites.hpp"

namespace sphonic {

/// Takes from a scalar next to the walls of obstacles what is rough in it, R f: at each particle within 2.5 dx of a wall the
/// difference from a weighted least-squares fit, exact for linear fields, of its surroundings of that radius. Once per step
///   f -= (1 - exp(-0.2 c0 dt/dx)) R^T R f,
/// which takes norm from every f. Virtual particles behind a curved wall are no mirror images, and feed some of the shortest
/// waves by a little; this takes more, and from sound of many points per wavelength next to nothing.
class WallSmoothing {
public:
    WallSmoothing(const Case& scene, const Sites& sites, int threads);

    /// Over a step of dt [s].
    void apply(double* field, double dt);

private:
    static constexpr double radius = 2.5, rate = 0.2;    ///< [dx], [c0/dx]
    struct Matrix {
        std::vector<std::int64_t> start;    ///< first entry of each row, and the end
        std::vector<std::int32_t> column;
        std::vector<double> value;
        std::vector<std::int32_t> number{};    ///< the particle of each row
    };
    double speed_;      ///< c0/dx [1/s]
    int threads_;
    Matrix rows_;       ///< R, over particles
    Matrix columns_;    ///< its transpose, over the rows of R
    std::vector<double> rough_;

    void find_rows(const Case& scene, const Sites& sites);
    void transpose();
};

}    // namespace sphonic
