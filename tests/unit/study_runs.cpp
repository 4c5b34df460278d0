#include "../support/study_bench.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace sphonic;

namespace {

using Status = StudyResult::Status;

/// Two steps, three runs of each.
struct Bench : testing::StudyBench {
    Study study(const std::string& values = "[0.5, 1]", const std::string& more = R"("repeat": 3)") const {
        return study_of(R"({ "name": "C", "pointer": "/integrator/courant", "values": )" + values + "}", more);
    }
    std::vector<Json> runs() const {
        std::ifstream in(out / "runs.jsonl");
        std::vector<Json> all;
        for (std::string line; std::getline(in, line);) all.push_back(parse_json(line, "line"));
        return all;
    }
    void write_runs(const std::vector<Json>& runs, const std::string& torn = "") const {
        std::ofstream file(out / "runs.jsonl");
        for (const Json& run : runs) file << run.dump() << '\n';
        file << torn;
    }
    /// What a study tells whose runs of the first point had these times.
    StudyResult timed(const std::vector<double>& cpu_s, const std::vector<double>& wall_s) {
        const Study given = study("[0.5]");
        run_study(given, registry, out, true);
        std::vector<Json> all = runs();
        for (std::size_t r = 0; r < 3; ++r) all[r]["summary"]["cpu_s"] = cpu_s[r], all[r]["summary"]["wall_s"] = wall_s[r];
        write_runs(all);
        return collect_study(given, out)[0];
    }
};

}    // namespace

TEST_CASE("the repetitions of a study run in turn over its points") {
    Bench bench;
    run_study(bench.study(), bench.registry, bench.out, false);
    std::vector<std::pair<int, int>> order;
    for (const Json& run : bench.runs()) order.emplace_back(run["repetition"], run["point"]);
    CHECK(order == std::vector<std::pair<int, int>>{{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 1}, {3, 2}});
}

TEST_CASE("a point's CPU time is the median of its runs, and its spread lies between the quartiles") {
    const StudyResult result = Bench().timed({1.02, 1, 1.08}, {1.02, 1, 1.08});
    CHECK(result.summary.cpu_s == 1.02);
    CHECK(result.timing.runs == 3);
    CHECK(result.timing.low == Approx(1.01).epsilon(1e-12));
    CHECK(result.timing.high == Approx(1.05).epsilon(1e-12));
    CHECK(result.timing.doubt.empty());
}

TEST_CASE("times that scatter or that were waited for are in doubt") {
    CHECK(Bench().timed({1, 1.3, 1.6}, {1, 1.3, 1.6}).timing.doubt == "quartiles 23 % apart");
    CHECK(Bench().timed({1, 1, 1}, {1.5, 1, 1.2}).timing.doubt == "waited for the processor in 2 of 3 runs");
    CHECK(Bench().timed({1, 1, 1}, {1.5, 1, 1}).timing.doubt.empty());
}

TEST_CASE("points that ran beside others have times in doubt") {
    Bench bench;
    const Study study = bench.study();
    open_study(study, bench.registry, bench.out);
    for (const std::size_t point : {1u, 0u}) run_points(study, bench.registry, bench.out, {.only = point, .side_by_side = true});
    CHECK(unfinished_points(study, bench.out).empty());
    for (const StudyResult& result : collect_study(study, bench.out)) CHECK(result.timing.doubt == "ran side by side with others");
}

TEST_CASE("a study makes the runs that are missing in its folder and passes over a torn line") {
    Bench bench;
    const Study study = bench.study();
    const auto whole = run_study(study, bench.registry, bench.out, false);
    const std::vector<Json> all = bench.runs();
    const std::string last = all[3].dump();
    for (const std::size_t cut : {std::size_t(1), last.size() / 2, last.size()}) {
        bench.write_runs({all.begin(), all.begin() + 3}, last.substr(0, cut));
        const auto again = run_study(study, bench.registry, bench.out, false);
        const std::vector<Json> now = bench.runs();
        REQUIRE(now.size() == 6);
        for (std::size_t i = 0; i < 3; ++i) CHECK(now[i] == all[i]);
        CHECK(now[3]["point"] == all[3]["point"]);
        for (std::size_t i = 0; i < 2; ++i) CHECK(again[i].summary.errors->l2 == whole[i].summary.errors->l2);
    }
}

TEST_CASE("a study whose points have changed is not mixed with the runs of the old ones") {
    Bench bench;
    const auto refusal = [&](const Study& study) {
        try {
            open_study(study, bench.registry, bench.out);
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string("no error");
    };
    open_study(bench.study(), bench.registry, bench.out);
    CHECK(refusal(bench.study()) == "no error");
    CHECK(refusal(bench.study("[0.5, 1]", R"("repeat": 5, "title": "Another")")) == "no error");
    const std::string remedy = ". Give --force to replace it, or another --out", holds = bench.out.string() + ": holds another study: ";
    const std::string file = (bench.folder / "study.json").string();
    CHECK(refusal(bench.study("[0.5, 1.5]")) == holds + file + ": point 2 of 2 (C = 1.5) is another case there" + remedy);
    CHECK(refusal(bench.study("[0.5, 1, 1.5]")) == holds + "it has 2 points, " + file + " has 3" + remedy);
    CHECK(refusal(bench.study("[0.5, 1]", R"("cutoff": 2)")) == holds + "cutoff is null there and 2.0 here" + remedy);
    std::ofstream(bench.folder / "tone.json", std::ios::app) << ' ';
    CHECK(refusal(bench.study()) == "no error");
    Json scene = read_json(bench.folder / "tone.json");
    scene["medium"]["c0"] = 341;
    std::ofstream(bench.folder / "tone.json") << scene;
    CHECK(refusal(bench.study()) == holds + file + ": point 1 of 2 (C = 0.5) is another case there" + remedy);
}

TEST_CASE("a run beyond the cut-off is given up and its point marked") {
    Bench bench;
    const auto results = run_study(bench.study("[0.5, 1e-6]", R"("cutoff": 0.3)"), bench.registry, bench.out, false);
    CHECK(results[0].status == Status::done);
    CHECK(results[1].status == Status::cut_off);
    CHECK(results[1].why == "took more than 0.3 s of CPU time");
    CHECK(results[1].summary.cpu_s < 1);
}

TEST_CASE("a point that fails is not repeated") {
    Bench bench;
    const auto results = run_study(bench.study("[0.5, 50]"), bench.registry, bench.out, false);
    CHECK(results[1].status == Status::refused);
    CHECK(bench.runs().size() == 4);
}

TEST_CASE("the tables of a study that was not finished tell which points are missing") {
    Bench bench;
    const Study study = bench.study();
    open_study(study, bench.registry, bench.out);
    CHECK(was_interrupted(study, bench.registry, bench.out));
    run_points(study, bench.registry, bench.out, {.only = 1});
    CHECK(unfinished_points(study, bench.out) == std::vector<std::size_t>{0});
    const auto results = collect_study(study, bench.out);
    CHECK(results[0].status == Status::missing);
    CHECK(results[1].status == Status::done);
}

TEST_CASE("a study tells how long it will still take once a run has ended") {
    Bench bench;
    std::vector<std::optional<double>> left;
    const auto listen = [&](const StudyProgress& p) {
        if (p.fraction == 1 && p.result) left.push_back(p.left_s);
    };
    const Study study = bench.study();
    open_study(study, bench.registry, bench.out);
    run_points(study, bench.registry, bench.out, {}, listen);
    const std::vector<Json> runs = bench.runs();
    const double first = runs[0]["took_s"], second = runs[1]["took_s"];
    REQUIRE(left.size() == 6);
    CHECK(*left[0] == Approx(5 * first));
    CHECK(*left[1] == Approx(2 * (first + second)));
    CHECK(*left[5] == 0);
}

TEST_CASE("a study's chart tells the power with which its curves go") {
    Bench bench;
    const Study study = bench.study("[0.25, 0.5, 1]", R"("charts": [ { "type": "value", "name": "slopes", "x": "C", "x_log": true, "y_log": true, "slopes": true } ])");
    run_study(study, bench.registry, bench.out, false);
    std::vector<Json> runs = bench.runs();
    for (std::size_t i = 0; i < 3; ++i) runs[i]["summary"]["errors"]["l2"] = std::pow(2, 2.5 * double(i));
    bench.write_runs(runs);
    collect_study(study, bench.out);
    CHECK_THAT(bench.picture("slopes"), Catch::Contains("slope 2.50"));
}

TEST_CASE("a dimension is called by its whole name, a pointer by its last member") {
    Bench bench;
    const std::string charts = R"("charts": [ { "type": "value", "name": "named", "x": "c0 dt/dx" }, { "type": "value", "name": "pointed", "x": "/integrator/courant" } ])";
    const Study study = bench.study_of(R"({ "name": "c0 dt/dx", "pointer": "/integrator/courant", "values": [0.5, 1] })", charts);
    CHECK(study.points[0].name == "c0 dt/dx = 0.5");
    CHECK(study.charts[0].x_label == "c0 dt/dx");
    CHECK(study.charts[1].x_label == "courant");
    run_study(study, bench.registry, bench.out, false);
    CHECK_THAT(bench.picture("named"), Catch::Contains("c0 dt/dx"));
}

TEST_CASE("the reading of a target is the cheapest point of each family that meets it") {
    Bench bench;
    const Study study = bench.study(R"([ {"label": 0.25, "family": "fine", "set": {"/integrator/courant": 0.25}}, {"label": 0.5, "family": "fine", "set": {"/integrator/courant": 0.5}},
        {"label": 1, "family": "coarse", "set": {"/integrator/courant": 1}} ])", R"("targets": [10, 1e-9])");
    std::vector<StudyResult> results(3);
    for (std::size_t i = 0; i < 3; ++i) results[i].status = Status::done, results[i].summary.errors = Errors{.l2 = 0.5}, results[i].summary.cpu_s = 3.0 - double(i);
    const auto readings = study_readings(study, results);
    REQUIRE(readings.size() == 2);
    CHECK(readings[0].family == "coarse");
    CHECK(readings[1].point == 1);
    results[1].status = Status::diverged;
    CHECK(study_readings(study, results)[1].point == 0);
}

TEST_CASE("times are told in units in which they are numbers that people read") {
    CHECK(time_text(2.04) == "2 s");
    CHECK(time_text(340.2) == "340 s");
    CHECK(time_text(0.0123) == "12 ms");
    CHECK(time_text(1.44e-4) == "144 µs");
    CHECK(time_text(0) == "0 s");
}
