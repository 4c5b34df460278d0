#pragma once
#include <optional>
#include <vector>

#include "choices.hpp"
#include "judge.hpp"

namespace sphonic {

/// A choice at the coarsest spacing at which it meets the target.
struct Found {
    Choice choice;
    double dx;
    Json document;
    Judgement judgement;
};

/// What a search came to: all that was found, cheapest first, and else the nearest miss.
struct Search {
    std::vector<Found> found;
    std::optional<Found> nearest;
    bool out_of_budget = false;
    bool cut_short = false;    ///< something was found, and to look on took a quarter of the budget
    std::string refused;    ///< the last reason of a case that was
};

/// Goes through all choices, each from coarse spacings to fine until it meets `target`, costs far more than the best, or is outdone.
Search search(const OpenCase& open, double target, double shortest, Judge& judge);

/// Runs the cheapest few where a run is so short that its cost is foreseen badly, and puts first what takes clearly least.
void time_cheapest(Search& search, Judge& judge);

}    // namespace sphonic
