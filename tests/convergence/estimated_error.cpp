/// The error where theory does not reach, estimated from coarser runs, beside the measured one.
#include <sphonic/prediction.hpp>

#include "../support/scene.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

struct Pair {
    double predicted, measured;
    std::string basis;
};

Pair errors(const std::string& name, const std::vector<std::string>& set) {
    const Case c = repository_case(name, set);
    Simulation simulation(c);
    const Prediction p = predict(c, simulation.summary(), Trials::allowed);
    INFO(name << ": " << p.basis);
    REQUIRE(p.l2);
    simulation.run();
    REQUIRE(simulation.summary().errors);
    return {*p.l2, simulation.summary().errors->l2, p.basis};
}

void agrees(const Pair& e, double factor) {
    CAPTURE(e.predicted, e.measured, e.basis);
    CHECK(e.predicted < factor * e.measured);
    CHECK(e.predicted > e.measured / factor);
}

std::string spacing(double dx) { return "/particles/dx=" + Json(dx).dump(); }

const std::string mur = R"(/boundaries=[{"type":"absorbing_mur","face":"all"}])", corrected = "/equations=corrected_acoustics";
const std::string pulse = "scenes/pulse_2d", late = "/until=0.009", stepped = R"(/integrator={"type":"leapfrog","courant":0.5})";

}    // namespace

TEST_CASE("the error of several media, disorder, bodies and open walls is estimated to a factor of 3", "[prediction][estimates]") {
    agrees(errors("suite/air_water", {}), 3);
    agrees(errors("suite/air_water", {R"(/method={"type":"fdtd"})", "/particles/dx=0.01"}), 3);
    agrees(errors("suite/jittered_box", {spacing(0.02)}), 3);
    agrees(errors("suite/circle_scattering_2d", {}), 3);
    agrees(errors(pulse, {corrected, late, stepped, mur, spacing(0.05)}), 3);
    agrees(errors(pulse, {late, stepped, mur, spacing(0.05), R"(/method={"type":"fdtd"})"}), 3);
}

TEST_CASE("what absorbing layers return is part of the predicted error, to a factor of 2", "[prediction][estimates]") {
    for (const char* attenuation : {"20", "66"}) {
        const Pair e = errors("suite/pulse_3d_absorbed", {std::string("/boundaries/0/attenuation=") + attenuation});
        CAPTURE(attenuation);
        agrees(e, 2);
    }
}

TEST_CASE("estimates rank as runs do: finer sets and better forms", "[prediction][estimates]") {
    struct Two {
        const char* scene;
        std::vector<std::string> worse, better;
    };
    for (const Two& two : {Two{"suite/air_water", {spacing(0.02)}, {spacing(0.01)}}, Two{"suite/jittered_box", {spacing(0.04)}, {spacing(0.02)}},
                           Two{"suite/jittered_box", {spacing(0.02), "/equations=linear_acoustics"}, {spacing(0.02)}}}) {
        const Pair worse = errors(two.scene, two.worse), better = errors(two.scene, two.better);
        CAPTURE(two.scene, worse.predicted, worse.measured, better.predicted, better.measured);
        CHECK(worse.measured > better.measured);
        CHECK(worse.predicted > better.predicted);
    }
}

TEST_CASE("where an error cannot be foreseen the basis says why", "[prediction][estimates]") {
    const Case c = scene(periodic_box(1, 40), {"/particles/jitter=0.1", "/equations=corrected_acoustics"});
    const Simulation simulation(c);
    const Prediction p = predict(c, simulation.summary(), Trials::allowed);
    CHECK(!p.l2);
    CHECK(p.basis.find("no exact solution") != std::string::npos);
    CHECK(predict(c, simulation.summary()).basis.find("l2") == std::string::npos);
}
