#pragma once
#include <vector>

#include "lattice_operators.hpp"
#include "row_mends.hpp"

namespace sphonic {

/// What a derivative's stencil leaves wrong: near the open ends of a lattice, where neighbours are missing, the own value's
/// weights do not cancel, and a correction is another one; near another medium the form weighs the values otherwise.
/// `stencils` are the interior's weights by medium.
RowMends lattice_mends(const LatticeGrid& grid, const Term& term, const std::vector<std::vector<Offset>>& stencils);

}    // namespace sphonic
