#pragma once
#include <cmath>
#include <optional>
#include <string>

#include <sphonic/case.hpp>

namespace sphonic {

/// The error of a run from initial fields on a regular set of one medium, from theory alone: every wave that the fields consist of
/// by the scheme's own map over all its steps (viscosity at half strength), their sum after so many steps beside that of the continuous waves, in
/// the region of the case's reference.
struct FieldError {
    double error, power;    ///< sums of squares over the points [Pa^2]
    std::string basis;

    double l2() const { return std::sqrt(error / power); }
};

/// Nothing, and in `why` the reason, for a case with sources, several media, walls that are no mirrors, or too many waves to follow.
/// Waves that together have less than `precision` of the fields' amplitude are left out.
std::optional<FieldError> field_error(const Case& scene, double dt, long steps, std::string& why, double precision = 1e-6);

}    // namespace sphonic
