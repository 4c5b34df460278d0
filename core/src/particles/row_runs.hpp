#pragma once
#include <algorithm>
#include <vector>

#include "neighbour_list.hpp"
#include "store.hpp"

namespace sphonic {

/// Consecutive particles whose rows are that of the first shifted along: the same weights at the same distances in the numbering.
struct RowRun {
    long begin, end;
};

/// All such ranges of at least sixteen particles, in their order. Where bodies stand among particles on a lattice's sites those are most of the
/// set, and what is read of their weights is one row's. `own` and `other` as in FrozenWeights; weights differ by rounding of places only.
std::vector<RowRun> runs_of_rows(const NeighbourList& list, long particles, const Array* own, const Array* other);

/// Calls run(a whole run's first particle, begin, end) for what lies in runs, else rows(begin, end), over [begin, end).
template <class InRun, class InRows>
void over_runs(const std::vector<RowRun>& runs, long begin, long end, InRun in_run, InRows in_rows) {
    auto run = std::ranges::upper_bound(runs, begin, {}, &RowRun::end);
    while (begin < end) {
        const long next = run == runs.end() ? end : std::min(end, run->begin);
        if (begin < next) in_rows(begin, next);
        if (next == end) return;
        begin = std::max(begin, run->begin);
        const long last = std::min(end, run->end);
        in_run(run->begin, begin, last);
        begin = last;
        ++run;
    }
}

}    // namespace sphonic
