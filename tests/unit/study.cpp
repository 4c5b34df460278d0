#include <sphonic/error.hpp>
#include <sphonic/study.hpp>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace sphonic;
namespace fs = std::filesystem;

namespace {

/// A folder with a small case, tone.json, and a study beside it.
struct Desk {
    fs::path folder = fs::temp_directory_path() / ("sphonic_study_" + std::to_string(getpid()));
    fs::path file = folder / "study.json";

    Desk() {
        fs::create_directories(folder);
        write("tone.json", R"({ "title": "Tone", "dimension": 1, "medium": { "c0": 340, "rho0": 1 },
            "particles": { "type": "lattice", "dx": 0.1, "lower": [-2], "upper": [8], "motion": "frozen" },
            "kernel": { "type": "cubic_spline", "h_over_dx": 1 }, "equations": "linear_acoustics",
            "viscosity": { "type": "monaghan", "alpha": 0.03, "beta": 0.5 },
            "sources": [ { "type": "plane_wave", "region": "x < 0", "amplitude": 1, "omega": 500, "direction": [1] } ],
            "integrator": { "type": "symplectic_euler", "courant": 0.5 }, "until": 0.01,
            "reference": { "type": "plane_wave_front", "region": "0 <= x <= 8", "scale": 1 } })");
    }
    ~Desk() { fs::remove_all(folder); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
    Study study(const std::string& members, const std::vector<std::string>& overrides = {}) const {
        write("study.json", "{" + members + "}");
        return load_study(file, overrides);
    }
    /// What a study with these members is refused with, after its file's name.
    std::string refusal(const std::string& members) const {
        try {
            study(members);
        } catch (const Error& e) {
            return std::string(e.what()).substr(file.string().size() + 2);
        }
        return "no error";
    }
};

std::vector<std::string> lines(const fs::path& file) {
    std::ifstream in(file);
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

const std::string two = R"("case": "tone.json", "vary": [
    { "name": "alpha", "pointer": "/viscosity/alpha", "values": [0, 0.03] },
    { "name": "step", "values": [ { "label": "small", "set": { "/integrator/courant": 0.5, "/until": 0.005 } },
                                  { "label": "large", "set": { "/integrator/courant": 1.5 } } ] } ])";

struct Refused {
    std::string members, message;
};

}    // namespace

TEST_CASE("the dimensions of a study are crossed with the first one slowest") {
    const Study study = Desk().study(two);
    std::vector<std::string> names;
    for (const StudyPoint& point : study.points) names.push_back(point.name);
    CHECK(names == std::vector<std::string>{"alpha = 0, small", "alpha = 0, large", "alpha = 0.03, small",
                                            "alpha = 0.03, large"});
}

TEST_CASE("a value of a study sets all its members together and overrides come last") {
    const Study study = Desk().study(two, {"/viscosity/beta=0"});
    const Json& small = study.points[0].document;
    CHECK(small["viscosity"] == Json({{"type", "monaghan"}, {"alpha", 0}, {"beta", 0}}));
    CHECK(small["integrator"]["courant"] == 0.5);
    CHECK(small["until"] == 0.005);
    CHECK(study.points[1].document["until"] == 0.01);
    CHECK(study.points[1].set == Json({{"/viscosity/alpha", 0}, {"/integrator/courant", 1.5}}));
}

TEST_CASE("a dimension of a study can tie several members to one value and tag families with its labels") {
    const Study study = Desk().study(R"("case": "tone.json", "vary": [
        { "name": "dx", "pointer": ["/particles/dx", "/kernel/h"], "values": [0.1, 0.05], "family": true },
        { "name": "C", "pointer": "/integrator/courant", "values": [0.5, 1] } ])");
    REQUIRE(study.points.size() == 4);
    CHECK(study.points[3].document["particles"]["dx"] == 0.05);
    CHECK(study.points[3].document["kernel"]["h"] == 0.05);
    CHECK(study.points[0].family == "dx = 0.1");
    CHECK(study.points[3].family == "dx = 0.05");
}

TEST_CASE("a value of a study can remove members and choose another case") {
    const Desk desk;
    desk.write("other.json", R"({ "title": "Other", "boundaries": [1, 2] })");
    const Study study = desk.study(R"("case": "tone.json", "vary": [ { "name": "model", "values": [
        { "label": "bare", "remove": ["/viscosity", "/sources/0"] },
        { "label": "other", "family": "walls", "case": "other.json", "remove": ["/boundaries/0"] } ] } ])");
    CHECK_FALSE(study.points[0].document.contains("viscosity"));
    CHECK(study.points[0].document["sources"].empty());
    CHECK(study.points[0].removed == Json({"/viscosity", "/sources/0"}));
    CHECK(study.points[1].document == Json({{"title", "Other"}, {"boundaries", {2}}}));
    CHECK(study.points[1].family == "walls");
}

TEST_CASE("what an earlier dimension set and a later one removes is not said to be set") {
    const Study study = Desk().study(R"("case": "tone.json", "vary": [ { "name": "a", "values": [ { "label": 1, "set": { "/title": "T", "/viscosity/alpha": 0.5 } } ] },
        { "name": "b", "values": [ { "label": "bare", "remove": ["/viscosity/alpha"] } ] } ])");
    CHECK_FALSE(study.points[0].document["viscosity"].contains("alpha"));
    CHECK(study.points[0].set == Json({{"/title", "T"}}));
}

TEST_CASE("a printed value belongs to the points whose labels its row gives") {
    const Study study = Desk().study(two + R"(, "measure": "errors.eps",
        "printed": { "columns": ["step", "eps", "/viscosity/alpha"], "rows": [["large", 2e-4, 0.030], ["small", 3e-4, 0.0]] })");
    CHECK(study.points[0].printed == 3e-4);
    CHECK_FALSE(study.points[1].printed);
    CHECK_FALSE(study.points[2].printed);
    CHECK(study.points[3].printed == 2e-4);
}

TEST_CASE("a study file that says something else than it may is refused where it says it") {
    const auto [members, message] = GENERATE_COPY(values<Refused>({
        {R"("vary": [], "case": "tone.json")",
         R"(/vary: [] is not a list with entries. Give [ { "name": ..., "pointer": ..., "values": [...] } ])"},
        {R"("vary": [ { "name": "a", "vlaues": [1] } ])", "/vary/0/vlaues: unknown key \"vlaues\". Did you mean \"values\"?"},
        {R"("vary": [ { "name": "a", "pointr": "/b", "values": [ { "label": 1 } ] } ])",
         R"(/vary/0/pointr: unknown key "pointr". Did you mean "pointer"?)"},
        {R"("vary": [ { "name": "a", "values": [0.5] } ])",
         R"(/vary/0/values/0: 0.5 goes nowhere. Give the dimension a "pointer", or write { "label": ..., "set": { "/pointer": value } })"},
        {R"("vary": [ { "name": "a", "pointer": "/x", "values": [1, "1"] } ])",
         R"(/vary/0/values/1: the label "1" is given twice. Label each value differently)"},
        {R"("vary": [ { "name": "steps", "values": [ { "label": 1 } ] } ])",
         R"(/vary/0/name: "steps" is not free. Choose a name that is no measure, no pointer and not "family")"},
        {two + R"(, "measure": "errors.L2")",
         "/measure: \"errors.L2\" is not one of errors.eps, errors.rms, errors.l2, errors.max, cpu_s, wall_s, "
         "setup_s, steps, dt, dt_limit, particles, ns_per_particle_step, neighbours_mean, memory_bytes. Did you mean "
         "\"errors.l2\"?"},
        {two + R"(, "chart": [])", R"(/chart: unknown key "chart". Did you mean "charts"?)"},
        {two + R"(, "repeat": 0)", "/repeat: 0 is no number of runs. Give an integer from 1 to 1000"},
        {two + R"(, "charts": [ { "type": "value", "name": "c", "x": "alhpa" } ])",
         R"(/charts/0/x: "alhpa" is no dimension of this study. Did you mean "alpha"?)"},
        {two + R"(, "charts": [ { "type": "value", "name": "c", "x": "step" } ])",
         "/charts/0/x: no point has a number at step. Name a dimension with numbers or a pointer to one"},
        {two + R"(, "charts": [ { "type": "value", "name": "c", "x": "alpha", "x_log": true, "order": 2 } ])",
         "/charts/0/order: a slope shows on logarithmic axes only. Set x_log and y_log too, or leave it out"},
        {two + R"(, "charts": [ { "type": "value", "name": "c", "x": "alpha", "slopes": true } ])",
         "/charts/0/slopes: a slope shows on logarithmic axes only. Set x_log and y_log too, or leave it out"},
        {two + R"(, "cutoff": 0)", "/cutoff: 0 is not positive. Give the seconds of CPU time after which a run is given up"},
        {two + R"(, "targets": [-1])", "/targets: -1 is not positive. Give a list of positive numbers"},
        {two + R"(, "measure": ["errors.l2", "errors.l2"])", R"(/measure: "errors.l2" is given twice. Name each once)"},
        {two + R"(, "charts": [ { "type": "value", "name": "../c", "x": "alpha" } ])",
         R"(/charts/0/name: "../c" is no file name. Use letters, digits, - and _)"},
        {two + R"(, "printed": { "columns": ["alpha", "l2"], "rows": [[0.07, 1]] })",
         "/printed/rows/0: no point of the study is meant. Correct its labels or remove it"},
        {two + R"(, "printed": { "columns": ["alpha"], "rows": [[0.03]] })",
         R"(/printed/columns: one column must be the measure. Give names of dimensions and "errors.l2")"},
        {R"("vary": [ { "name": "a", "pointer": "/x", "values": [1, 2] } ])",
         R"(point 1 of 2 (a = 1): case: is missing. Give "case" in the study or in the value)"},
        {R"("case": "tone.json", "vary": [ { "name": "a", "values": [ { "label": "b", "remove": ["/viscosty"] } ] } ])",
         R"(point 1 of 1: remove: "/viscosty" is not in the case. Did you mean "/viscosity"?)"},
    }));
    const std::string given = members;
    CHECK(Desk().refusal(given) == message);
}

TEST_CASE("a study names the point whose case is refused before it runs any") {
    const Desk desk;
    const Study study = desk.study(
        R"("case": "tone.json", "vary": [ { "name": "h", "pointer": "/kernel/h_over_dx", "values": [1, -1] } ])");
    Registry registry(Registry::search_path());
    CHECK_THROWS_WITH(run_study(study, registry, desk.folder / "out", false),
                      Catch::StartsWith(desk.file.string() + ": point 2 of 2 (h = -1): ") &&
                          Catch::Contains("tone.json: /kernel/h_over_dx: -1 is out of range"));
    CHECK_FALSE(fs::exists(desk.folder / "out"));
}

TEST_CASE("a study marks the points that fail and keeps the others") {
    const Desk desk;
    const Study study = desk.study(
        R"("case": "tone.json", "measure": "errors.l2", "vary": [ { "name": "C", "pointer": "/integrator/courant", "values": [0.5, 50] } ],
        "printed": { "columns": ["C", "l2"], "rows": [[0.5, 0.5]] })");
    Registry registry(Registry::search_path());
    const fs::path out = desk.folder / "out";
    const auto results = run_study(study, registry, out, false);
    CHECK(results[0].status == StudyResult::Status::done);
    CHECK(results[1].status == StudyResult::Status::refused);

    const auto points = lines(out / "points.jsonl");
    REQUIRE(points.size() == 2);
    const Json first = parse_json(points[0], "first"), second = parse_json(points[1], "second");
    CHECK(first["labels"]["C"] == 0.5);
    CHECK(first["ratio"].get<double>() == Approx(2 * first["errors"]["l2"].get<double>()));
    CHECK(second["status"] == "refused");
    CHECK(second["errors"].is_null());
    CHECK(lines(out / "table.csv").size() == 3);
    CHECK_THAT(lines(out / "table.md").at(5), Catch::StartsWith("| 50 ") && Catch::Contains("refused"));
}

TEST_CASE("a study goes on in a folder of its own, replaces it when told to and touches nothing else") {
    const Desk desk;
    const std::string one = R"("case": "tone.json", "vary": [ { "name": "C", "pointer": "/integrator/courant", "values": [1] } ], "repeat": 2)";
    const Study study = desk.study(one);
    Registry registry(Registry::search_path());
    const fs::path out = desk.folder / "out";
    run_study(study, registry, out, false);
    const auto before = lines(out / "runs.jsonl");
    run_study(study, registry, out, false);
    CHECK(lines(out / "runs.jsonl") == before);
    run_study(study, registry, out, true);
    CHECK(lines(out / "runs.jsonl") != before);
    CHECK(lines(out / "points.jsonl").size() == 1);
    CHECK_THROWS_WITH(run_study(study, registry, desk.folder, true),
                      desk.folder.string() + ": holds something other than a study. Give another --out");
    CHECK(fs::exists(desk.file));
}
