#include "../support/study_bench.hpp"

#include <catch2/catch.hpp>

using namespace sphonic;

namespace {

using Status = StudyResult::Status;

/// Two dimensions of numbers, the wave's frequency and the step.
struct Bench : testing::StudyBench {
    Study study(const std::string& more, const std::string& steps = "[0.25, 0.5]") const {
        return study_of(R"({ "name": "omega", "pointer": "/sources/0/omega", "values": [300, 500, 800] }, { "name": "C", "pointer": "/integrator/courant", "values": )" + steps + " }", more);
    }
    std::string refusal(const std::string& more, const std::string& steps = "[0.25, 0.5]") const {
        try {
            study(more, steps);
        } catch (const Error& e) {
            return std::string(e.what()).substr((folder / "study.json").string().size() + 2);
        }
        return "no error";
    }
};

StudyResult done(double l2, double cpu_s) {
    StudyResult result{.status = Status::done};
    result.summary.errors = Errors{.l2 = l2};
    result.summary.cpu_s = result.timing.low = result.timing.high = cpu_s;
    result.predicted_l2 = 2 * l2;
    result.predicted_cpu_s = cpu_s;
    return result;
}

}    // namespace

TEST_CASE("over a dimension the worst point counts, at the mean of the times", "[study]") {
    const Study study = Bench().study(R"("worst_over": "omega", "targets": [0.25])");
    const std::vector<StudyResult> results{done(0.1, 1), done(0.01, 10), done(0.3, 2), done(0.02, 20), done(0.2, 6), done(0.03, 60)};
    const StudyView view = worst_view(study, results);
    REQUIRE(view.results.size() == 2);
    CHECK(view.study.vary.size() == 1);
    CHECK(view.study.points[0].name == "C = 0.25");
    CHECK(view.study.points[0].document["sources"][0]["omega"] == 500);
    CHECK(view.study.points[1].document["sources"][0]["omega"] == 800);
    CHECK(measured(view.results[0], "errors.l2") == 0.3);
    CHECK(measured(view.results[0], "cpu_s") == Approx(3));
    CHECK(*view.results[0].predicted_l2 == Approx(0.6));
    CHECK(measured(view.results[1], "errors.l2") == 0.03);
    CHECK(view.results[1].timing.high == Approx(30));
    const auto readings = study_readings(view.study, view.results);
    REQUIRE(readings.size() == 1);
    CHECK(readings[0].point == 1);
}

TEST_CASE("where one point of a dimension fails, its worst has failed", "[study]") {
    const Study study = Bench().study(R"("worst_over": "C")");
    std::vector<StudyResult> results{done(0.1, 1), done(0.2, 1), done(0.3, 1), done(0.4, 1), done(0.5, 1), done(0.6, 1)};
    results[3].status = Status::diverged, results[3].why = "too loud";
    const StudyView view = worst_view(study, results);
    REQUIRE(view.results.size() == 3);
    CHECK(view.results[0].status == Status::done);
    CHECK(view.results[1].status == Status::diverged);
    CHECK(view.results[1].why == "too loud");
    CHECK(measured(view.results[2], "errors.l2") == 0.6);
}

TEST_CASE("without such a dimension a study is ranked as it is", "[study]") {
    const Study study = Bench().study(R"("repeat": 1)");
    const std::vector<StudyResult> results(6, done(0.1, 1));
    CHECK(worst_view(study, results).results.size() == 6);
}

TEST_CASE("a map draws the measure and the CPU time over two dimensions in classes that hold every value", "[study]") {
    Bench bench;
    const Study study = bench.study(R"("charts": [ { "type": "map", "name": "plane", "x": "omega", "y": "C", "y_log": true, "y_label": "c0 dt/dx" } ])");
    const auto results = run_study(study, bench.registry, bench.out, false);
    for (const StudyResult& result : results) CHECK(result.status == Status::done);
    const std::string picture = bench.picture("plane");
    for (const char* text : {"relative L2 error", "CPU time of stepping [s]", "omega", "c0 dt/dx", " to "}) CHECK_THAT(picture, Catch::Contains(text));
    CHECK_THAT(picture, !Catch::Contains("no value"));
}

TEST_CASE("a worst or a map of what is not there is refused where it is said", "[study]") {
    const Bench bench;
    const std::string map = R"("charts": [ { "type": "map", "name": "plane", )";
    CHECK(bench.refusal(R"("worst_over": "omgea")") == "/worst_over: \"omgea\" is no dimension of this study. Did you mean \"omega\"?");
    CHECK(bench.refusal(map + R"("x": "omega", "y": "omega" } ])") == "/charts/0/y: \"omega\" stands along x already. Name another dimension");
    CHECK(bench.refusal(map + R"("x": "omega", "y": "C" } ])", "[0.5]") ==
          "/charts/0/y: \"C\" is no dimension with two numbers or more. Name a dimension whose values are numbers");
}
