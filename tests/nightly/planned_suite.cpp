/// The suite's scenes, planned to one percent and to a thousandth, keep what was promised.
#include <sphonic/plan.hpp>

#include "../support/scene.hpp"

using namespace sphonic;
using namespace sphonic::testing;

TEST_CASE("every periodic or mirrored scene of the suite meets its target when it runs", "[plan]") {
    for (const char* name : {"propagation_1d", "standing_wave_2d", "air_water"})
        for (const double target : {0.01, 0.001}) {
            const std::filesystem::path file = SPHONIC_SOURCE_DIR "/cases/suite/" + std::string(name) + ".json";
            const Plan plan = make_plan(read_json(file), file, {.target = target, .free = true}, registry());
            const Case c = load_case(plan.document, file, registry());
            const Summary s = run(c);
            CAPTURE(name, target, plan.document.dump());
            REQUIRE(s.errors);
            CHECK(s.errors->l2 <= target);
        }
}
