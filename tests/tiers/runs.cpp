/// Rows of constant weights that are one row shifted along.
#include "row_runs.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace sphonic;

namespace {

/// nx by ny sites, all but one, with weights that follow the separation up to two spacings, where rounding decides which pairs are listed.
struct Sites {
    static constexpr long nx = 40, ny = 7, hole = 3 * nx + 20, n = nx * ny - 1;
    std::vector<double> x, y;
    abi::Box box{.dimension = 2, .dx = 1.1, .upper = {1.1 * (nx - 1), 1.1 * (ny - 1), 0}, .count = {nx, ny, 1}};
    NeighbourList list{box, n, 2.2, 0};
    Array own[3], other[3];

    Sites() {
        for (long i = 0; i < nx * ny; ++i)
            if (i != hole) x.push_back(double(i % nx) * 1.1), y.push_back(double(i / nx) * 1.1);
        const double* const places[3] = {x.data(), y.data(), nullptr};
        list.build(places, 0);
        for (int a = 0; a < 2; ++a) own[a] = Array(n), other[a] = Array(list.neighbour().size());
        for (long i = 0; i < n; ++i)
            for (auto k = list.start()[i]; k < list.start()[i + 1]; ++k) {
                const long j = list.neighbour()[k];
                const double dx = x[j] - x[i], dy = y[j] - y[i], slope = std::pow(std::max(0.0, 2.2 - std::hypot(dx, dy)), 2);
                own[0].data()[i] -= other[0].data()[k] = slope * dx;
                own[1].data()[i] -= other[1].data()[k] = slope * dy;
            }
    }
    std::vector<RowRun> runs() const { return runs_of_rows(list, n, own, other); }
};

}    // namespace

TEST_CASE("rows alike are found but at the ends of a lattice and next to a hole", "[runs]") {
    std::vector<std::pair<long, long>> expected, found;
    for (long row = 0; row < Sites::ny; ++row) {
        const long first = row * Sites::nx - (row > 3), last = first + Sites::nx - (row == 3), hole = first + 20;
        if (std::abs(row - 3) > 1) {
            expected.push_back({first + 1, last - 1});
        } else {
            expected.push_back({first + 1, hole - 1});
            expected.push_back({hole + (row == 3 ? 1 : 2), last - 1});
        }
    }
    for (const RowRun& run : Sites().runs()) found.push_back({run.begin, run.end});
    CHECK(found == expected);
}

TEST_CASE("weights that differ by more than rounding end a run", "[runs]") {
    Sites sites;
    const auto whole = sites.runs();
    const long inside = (whole[0].begin + whole[0].end) / 2;
    for (auto k = sites.list.start()[inside]; k < sites.list.start()[inside + 1]; ++k) sites.other[0].data()[k] *= 1 + 1e-9;
    const auto parted = sites.runs();
    CHECK(std::ranges::none_of(parted, [&](const RowRun& r) { return r.begin < inside && r.end > inside; }));
}

TEST_CASE("every particle is visited once and in order, in runs and between them", "[runs]") {
    const std::vector<RowRun> runs{{3, 20}, {20, 40}, {55, 80}};
    for (const auto& [begin, end] : {std::pair{0L, 100L}, {5L, 30L}, {20L, 20L}, {39L, 56L}, {80L, 90L}, {60L, 70L}}) {
        long next = begin;
        over_runs(runs, begin, end, [&](long first, long from, long to) {
            CHECK(from == next);
            CHECK(to > from);
            CHECK(std::ranges::any_of(runs, [&](const RowRun& r) { return r.begin == first && r.begin <= from && to <= r.end; }));
            next = to;
        }, [&](long from, long to) {
            CHECK(from == next);
            CHECK(std::ranges::none_of(runs, [&](const RowRun& r) { return r.begin < to && from < r.end; }));
            next = to;
        });
        CHECK(next == end);
    }
}
