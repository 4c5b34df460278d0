#include <catch2/catch.hpp>
#include <sphonic/prediction.hpp>

#include "../support/scene.hpp"

using namespace sphonic;
using namespace sphonic::testing;

/// By ratios measured on 200^2 points: bodies 1.95, a point 1.22, layers 2.26, and at order 4 a point 1.06 times what a plain step takes.
TEST_CASE("the cost of finite differences follows what acts between the halves of a step", "[cost]") {
    const auto seconds = [](int order, const std::string& set) {
        const std::string method = R"json(/method={"type":"fdtd","order":)json" + std::to_string(order) + "}";
        const Case c = scene(periodic_box(2, 200), {"/boundaries=[]", method, set});
        return predict(c, Simulation(c).summary()).cpu_s;
    };
    const std::string nothing = "/title=plain", bodies = R"(/obstacles=[{"type":"circle","centre":[0.5,0.5],"radius":0.2}])",
                      layers = R"(/boundaries=[{"type":"absorbing_layer","face":"all","thickness":0.2,"attenuation":40}])",
                      adding = R"(/sources=[{"type":"point","position":[0.5,0.5],"omega":6}])",
                      imposing = R"(/sources=[{"type":"plane_wave","region":"x < 0.2","omega":6,"direction":[1,0]}])";
    const double plain = seconds(2, nothing);
    CHECK(seconds(2, imposing) > 1.2 * plain);    // a sine for each point, every step
    CHECK(seconds(2, bodies) / plain == Approx(1.95).epsilon(0.3));
    CHECK(seconds(2, adding) / plain == Approx(1.22).epsilon(0.3));
    CHECK(seconds(2, layers) / plain == Approx(2.26).epsilon(0.3));
    CHECK(seconds(4, adding) / seconds(4, nothing) == Approx(1.06).epsilon(0.15));    // two passes anyway
}
