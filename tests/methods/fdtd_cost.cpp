#include <catch2/catch.hpp>
#include <sphonic/prediction.hpp>

#include "../support/scene.hpp"

using namespace sphonic;
using namespace sphonic::testing;

/// By the ratios measured in tests/benchmarks/README.md.
TEST_CASE("the cost of finite differences follows what acts between the halves of a step", "[cost]") {
    const auto seconds = [](int order, const std::string& set) {
        const std::string method = R"json(/method={"type":"fdtd","order":)json" + std::to_string(order) + "}";
        const Case c = scene(periodic_box(2, 24), {"/boundaries=[]", method, set});
        return predict(c, Simulation(c).summary()).cpu_s;
    };
    const std::string nothing = "/title=plain", bodies = R"(/obstacles=[{"type":"circle","centre":[0.5,0.5],"radius":0.2}])",
                      layers = R"(/boundaries=[{"type":"absorbing_layer","face":"all","thickness":0.2,"attenuation":40}])",
                      adding = R"(/sources=[{"type":"point","position":[0.5,0.5],"omega":6}])",
                      imposing = R"(/sources=[{"type":"plane_wave","region":"x < 0.2","omega":6,"direction":[1,0]}])";
    const double plain = seconds(2, nothing);
    CHECK(seconds(2, imposing) == Approx(plain));    // p between steps alone
    CHECK(seconds(2, bodies) / plain == Approx(1.5).margin(0.3));
    CHECK(seconds(2, adding) / plain == Approx(1.5).margin(0.3));
    CHECK(seconds(2, layers) / plain == Approx(1.95).margin(0.35));
    CHECK(seconds(4, adding) == Approx(seconds(4, nothing)));    // two passes anyway
}
