#pragma once
#include <optional>
#include <string>

#include <sphonic/simulation.hpp>

namespace sphonic {

/// An error that theory does not know, from runs of the same case at coarser spacings, and what it rests on. Without a value the basis
/// says why there is none.
struct Estimate {
    std::optional<double> l2;
    std::string basis;
};

/// Of a case as a whole: the errors E of runs at some 2 dx and 4 dx, continued by the order q that they show,
///   E(dx) = E(a dx) a^-q,   q = ln(E(b dx)/E(a dx)) / ln(b/a) from 0 (a set that has stalled stays so) to 4,
/// a and b next to 2 and 4 such that walls stay where they are. Where b dx cannot be run or is too coarse for the waves, q = 2.
Estimate estimated_error(const Case& scene);

/// What faces that let sound out, and the layers before them, add to the error: of a run at 2 dx what theory does not account for,
///   sqrt(E_run^2 - E_theory^2).
Estimate returned_by_faces(const Case& scene);

}    // namespace sphonic
