/// The spacings that a search may try.
#include "spacings.hpp"

#include <catch2/catch.hpp>
#include <sphonic/json.hpp>

using namespace sphonic;

TEST_CASE("between two spacings of a search lie at most three more, from coarse to fine, that fit the box", "[plan]") {
    const OpenCase open = opened(Json::parse(R"json({"dimension": 2, "medium": {"c0": 340, "rho0": 1.2}, "particles": {"type": "lattice", "lower": [0, 0], "upper": [4, 6]},
        "boundaries": [{"type": "rigid", "face": "all"}]})json"), "open.json", true);
    REQUIRE(open.spacing);
    for (const auto& [coarser, finer, expected] : {std::tuple{4.0 / 20, 4.0 / 30, std::vector<long>{22, 24, 26}}, {4.0 / 20, 4.0 / 26, {22, 24}}, {4.0 / 20, 4.0 / 22, {}}}) {
        std::vector<long> found;
        for (const double dx : spacings_between(open, coarser, finer)) found.push_back(std::lround(4 / dx));
        CHECK(found == expected);
    }
}
