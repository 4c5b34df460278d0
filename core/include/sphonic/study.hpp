#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sphonic/json.hpp>
#include <sphonic/registry.hpp>
#include <sphonic/simulation.hpp>

namespace sphonic {

/// One value of a dimension and what it does to the case: first `remove`, then `set`, in the order of the file.
struct StudyValue {
    Json label;                                       ///< a number, a string, true or false; printed rows name it
    std::string family;                               ///< of points in a cost chart; empty: none
    std::filesystem::path scene;                      ///< another case; empty: the study's
    std::vector<std::string> remove;                  ///< JSON pointers
    std::vector<std::pair<std::string, Json>> set;    ///< JSON pointer, value
};

struct StudyDimension {
    std::string name;
    std::vector<StudyValue> values;
};

/// A picture of the results. A *place* is a dimension, "family" or a JSON pointer into the case.
struct StudyChart {
    enum class Type { value, cost } type;
    std::string name;    ///< of its files
    std::string title;
    std::string x, y;    ///< a place (CPU time in a cost chart) and a measure
    std::string
        group;    ///< the place that names the curve; empty: the dimensions other than x that have several values
    std::string x_label, y_label;
    bool x_log = false, y_log = false;
    double order = 0;      ///< of a value chart on logarithmic axes: a triangle of this slope is drawn; 0: none
    double y_floor = 0;    ///< of a cost chart: what lies below is drawn here, with its value in its label
};

/// One run of the matrix, as asked for.
struct StudyPoint {
    std::vector<Json> labels;    ///< one per dimension
    std::string name;            ///< the labels that tell it from the others
    std::string family;
    std::filesystem::path file;    ///< of its case
    Json removed = Json::array(), set = Json::object();
    Json document;                    ///< the case with these changes and the overrides
    std::optional<double> printed;    ///< what a publication gives for the study's measure

    std::string full_name() const { return family.empty() ? name : family + ": " + name; }
};

/// Cases to run and compare. The first dimension varies slowest.
struct Study {
    std::filesystem::path file, scene;
    std::string title, description, measure;
    std::vector<StudyDimension> vary;
    std::string source;    ///< of the printed values
    std::vector<StudyChart> charts;
    int repeat = 1;
    int threads = 1;    ///< of each run: CPU times of one thread compare
    std::vector<std::string> overrides;
    std::vector<StudyPoint> points;
};

/// One run of the matrix, as it came out.
struct StudyResult {
    enum class Status { done, diverged, refused, unrepeatable } status = Status::done;
    std::string why;    ///< empty when done
    Summary summary;    ///< of the repetition with the median CPU time; empty when refused
};

struct StudyProgress {
    std::size_t index, total;
    const StudyPoint& point;
    double fraction;              ///< of this point
    const StudyResult* result;    ///< null while it runs
};

/// Reads a study and makes its points. `overrides` are "/pointer=value", applied to every case last.
Study load_study(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// Checks every case, runs them one after the other and fills `folder`: points.jsonl, one line when a point ends, so
/// that a killed study keeps what it has; at the end table.csv, table.md and the charts. A point that fails is marked.
/// With `force`, a folder that holds an earlier study is emptied first.
std::vector<StudyResult> run_study(const Study& study, Registry& registry, const std::filesystem::path& folder,
                                   bool force, const std::function<void(const StudyProgress&)>& progress = {});

/// The line of points.jsonl.
Json to_json(const Study& study, const StudyPoint& point, const StudyResult& result);
/// GitHub Markdown.
std::string study_markdown(const Study& study, const std::vector<StudyResult>& results);

}    // namespace sphonic
