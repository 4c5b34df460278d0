/// Predicted against measured limits, as `sphonic stability --table` shows them.
#include "../support/scene.hpp"

#include <map>

#include <sphonic/stability_table.hpp>

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("the limits of every kernel, width, integrator and dimension, with viscosity, disorder and walls, are those that theory says", "[nightly][bisection]") {
    LimitTable table(registry());
    std::map<std::string, int> rows;
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
        const LimitTable::Row& row = table.find(i);
        INFO(name_of(row) << ": predicted " << row.predicted << ", measured " << row.measured);
        CHECK(row.holds());
        ++rows[row.group];
    }
    for (const LimitTable::Worst& w : table.worst()) WARN(w.group << ": " << w.rows << " rows, worst " << 100 * w.deviation << " %");
    CHECK(rows["lattice"] >= 250);
    CHECK(rows["viscosity"] >= 40);
    CHECK(rows["disorder"] == 16);
    CHECK(rows["walls"] >= 10);
}
