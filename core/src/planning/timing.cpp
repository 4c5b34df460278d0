#include <algorithm>
#include <cmath>

#include "search.hpp"

namespace sphonic {
namespace {

constexpr double in_reach = 3;        ///< times the cheapest, by prediction: of short runs on few particles that is good to such a factor
constexpr double short_run = 0.02;    ///< [s]
constexpr std::size_t most_timed = 10;
constexpr double clearly = 0.85;      ///< below what chance makes of two equal times
constexpr double by_chance = 5e-6;    ///< that two runs differ by, however short [s]

}    // namespace

void time_cheapest(Search& search, Judge& judge) {
    std::vector<Found>& found = search.found;
    if (found.size() < 2) return;
    const double most = std::min(short_run, in_reach * found.front().judgement.cpu_s);
    std::size_t best = 0;
    double least = 0;
    for (std::size_t i = 0; i < std::min(found.size(), most_timed) && found[i].judgement.cpu_s <= most; ++i) {
        const double taken = judge.timed(found[i].document);
        if (i > 0 && taken >= std::min(clearly * least, least - by_chance)) continue;
        best = i, least = taken;
    }
    std::rotate(found.begin(), found.begin() + std::ptrdiff_t(best), found.begin() + std::ptrdiff_t(best) + 1);
}

}    // namespace sphonic
