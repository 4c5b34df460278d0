/// The atlas of failures: each must fail, be predicted where theory can, and be cured.
#include "../support/stability.hpp"

#include <cmath>
#include <set>

#include <sphonic/atlas.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

const std::filesystem::path folder = SPHONIC_SOURCE_DIR "/cases/failures";

/// A run is stopped at a hundred times the energy that it should have.
const double stopped = std::log(10.0);

/// RMS of what alternates from particle to particle over that of what does not, of p between two places of a line.
double sawtooth(const Profile& now, double lower, double upper) {
    double smooth = 0, rough = 0;
    for (std::size_t i = 1; i + 1 < now.p.size(); ++i) {
        if (now.x[0][i] < lower || now.x[0][i] > upper) continue;
        const double mean = 0.25 * (now.p[i - 1] + 2 * now.p[i] + now.p[i + 1]);
        smooth += mean * mean, rough += (now.p[i] - mean) * (now.p[i] - mean);
    }
    return std::sqrt(rough / smooth);
}

}    // namespace

TEST_CASE("every failure of the atlas fails, and its cures cure it", "[atlas]") {
    const Atlas atlas = load_atlas(folder);
    for (const AtlasRow& row : atlas.rows) {
        const AtlasResult result = run_row(atlas, row, registry());
        for (const std::vector<AtlasRun>* side : {&result.failures, &result.cures})
            for (const AtlasRun& run : *side) {
                INFO(row.name << (side == &result.cures ? ", cure " : ", failure ") << run.variant->name << ": " << run.outcome << ", by theory e^" << run.predicted.value_or(0));
                CHECK(run.as_told);
                if (run.predicted) CHECK((side == &result.cures ? *run.predicted < 1.1 : *run.predicted > stopped));
            }
    }
}

TEST_CASE("walls return and interfaces pass the sawtooth of a one-particle source as they do its sound, and nothing of a footprint's", "[atlas][sawtooth]") {
    const auto after = [](const std::string& name, const std::vector<std::string>& set, double lower, double upper) {
        const Case c = repository_case("failures/" + name, set);
        Simulation simulation(c);
        simulation.run();
        return sawtooth(simulation.profile(), lower, upper);
    };
    const std::string footprint = R"(/sources=[{"type":"point","position":[0.0125],"flow":0.004901960784313725,"omega":2136.2830044410593}])";
    for (const char* wall : {"rigid", "soft"}) {
        INFO(wall);
        const std::string set = std::string("/boundaries/0/type=") + wall, half_way = *wall == 's' ? "/until=0.0193" : "/until=0.018565";
        CHECK(after("sawtooth_at_wall", {set, half_way}, 1.5, 3) == Approx(1).epsilon(0.05));
        CHECK(after("sawtooth_at_wall", {set, half_way, footprint}, 1.5, 2.9) < 0.01);
    }
    CHECK(after("sawtooth_at_interface", {}, 2.1, 3.7) == Approx(1).epsilon(0.05));
    CHECK(after("sawtooth_at_interface", {footprint}, 2.1, 3.7) < 0.03);
}

TEST_CASE("every case of the atlas's folder stands in it, and is one that check takes", "[atlas]") {
    std::set<std::filesystem::path> told, there;
    for (const AtlasRow& row : load_atlas(folder).rows) told.insert(row.scene.filename());
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json") there.insert(entry.path().filename());
    CHECK(told == there);
    for (const auto& name : there) {
        INFO(name);
        CHECK_NOTHROW(Simulation(load_case(folder / name, {}, registry())));
    }
}

TEST_CASE("1 % beyond the limit noise grows and 1 % before it does not, for every integrator with a limit, kernel and dimension", "[atlas][limit]") {
    int rows = 0;
    for (int dimension = 1; dimension <= 3; ++dimension)
        for (const std::string& name : registry().names("kernel"))
            for (const std::string& type : registry().names("integrator")) {
                std::optional<Case> c;
                try {
                    c.emplace(quiet_box(dimension, side(dimension), {kernel(name, dimension == 3 ? 1 : 1.3), integrator(type)}));
                } catch (const Error&) {
                    continue;    // a dimension that the kernel does not claim, or no neighbour within reach
                }
                if (oscillator_limit(*c) == 0) continue;
                const double limit = StepTheory(*c).limit().dt;
                StabilityTrial trial(*c, {.steps = 600});
                INFO(name << ", " << type << " in " << dimension << "-D");
                CHECK(trial.run(0.99 * limit).stable);
                CHECK_FALSE(trial.run(1.01 * limit).stable);
                ++rows;
            }
    CHECK(rows >= 60);
}

TEST_CASE("sound beyond linear acoustics is told with its figures, wherever it comes from", "[atlas][warning]") {
    const auto warnings = [](const std::vector<std::string>& set, bool run) {
        const Case c = scene(periodic_box(1, 40), set);    // rho0 c0^2 = 6 Pa
        Simulation simulation(c);
        if (run) simulation.run();
        std::string all;
        for (const std::string& warning : simulation.summary().warnings) all += warning + "\n";
        return all;
    };
    using Catch::Matchers::Contains;
    CHECK(warnings({"/initial/p=0.05*sin(2*pi*x)"}, true).empty());
    CHECK_THAT(warnings({"/initial/p=0.6*sin(2*pi*x)"}, false), Contains("p/(rho0 c0^2) reaches 0.1 and the Mach number 0,"));
    CHECK_THAT(warnings({R"json(/initial/u=["0.4*sin(2*pi*x)"])json"}, false), Contains("Mach number 0.2,"));
    const std::string tone = R"(/sources=[{"type":"plane_wave","region":"x < 0.1","amplitude":3,"omega":12.56637}])";
    CHECK_THAT(warnings({tone}, false), Contains("p/(rho0 c0^2) reaches 0.5 and the Mach number 0.5,"));
    const std::string pulse = R"(/sources=[{"type":"point","position":[0.5],"flow":0.4,"signal":"gaussian","duration":0.05}])";
    CHECK(warnings({pulse, "/until=0.5"}, false).empty());
    CHECK_THAT(warnings({pulse, "/until=0.5"}, true), Contains("beyond linear acoustics"));
}
