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
    enum class Type { value, cost, map } type;
    std::string name;    ///< of its files
    std::string title;
    std::string x, y;    ///< a place (CPU time in a cost chart) and a measure, in a map two dimensions
    std::string measure{};    ///< of a map, which stands beside one of CPU time
    std::string
        group;    ///< the place that names the curve; empty: the dimensions other than x that have several values
    std::string x_label, y_label;
    bool x_log = false, y_log = false;
    double order = 0;      ///< of a value chart on logarithmic axes: a triangle of this slope is drawn; 0: none
    bool slopes = false;   ///< of a value chart on logarithmic axes: the legend gives the power of x with which each curve goes
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
    std::vector<std::string> also;     ///< more measures in the tables
    std::string worst_over;            ///< a dimension: points that differ in it alone count as one, by the worst of them; empty: none
    std::vector<StudyDimension> vary;
    std::string source;    ///< of the printed values
    std::vector<StudyChart> charts;
    std::vector<double> targets;       ///< of the measure: what is the cheapest point that meets each?
    int repeat = 1;
    int threads = 1;    ///< of each run: CPU times of one thread compare
    std::optional<double> cutoff;      ///< CPU time of stepping at which a run is given up [s]
    std::vector<std::string> overrides;
    std::vector<StudyPoint> points;
};

/// CPU times of stepping of a point's repetitions.
struct StudyTiming {
    int runs = 0;
    double low = 0, high = 0;    ///< quartiles [s], between order statistics; equal for one run
    std::string doubt;           ///< why they should not be trusted; empty: no reason is known
};

/// One point of the matrix, as it came out.
struct StudyResult {
    enum class Status { done, diverged, refused, unrepeatable, cut_off, missing } status = Status::missing;
    std::string why{};    ///< empty when done
    Summary summary{};    ///< of the repetition with the median CPU time; empty when refused or missing
    StudyTiming timing{};
    std::optional<double> predicted_l2{}, predicted_cpu_s{};    ///< by theory, before the run
};

struct StudyProgress {
    std::size_t index, total;
    const StudyPoint& point;
    int repetition, repetitions;    ///< from 1
    double fraction;                ///< of this repetition
    std::optional<double> left_s;   ///< wall time that the study will still take, by the runs that have ended
    const StudyResult* result;      ///< of the point so far, when a repetition has ended
};
using StudyListener = std::function<void(const StudyProgress&)>;

/// Which of the runs that are missing in a folder to make.
struct StudyWork {
    std::optional<std::size_t> only{};    ///< one point
    bool side_by_side = false;            ///< other runs share the machine: the times are marked
};

/// Reads a study and makes its points. `overrides` are "/pointer=value", applied to every case last.
Study load_study(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// Checks every case and prepares `folder`. One that holds runs of the same points is continued; other points are refused, and
/// with `force` an earlier study is emptied. With `only`, one point of a study that is there already is checked.
void open_study(const Study& study, Registry& registry, const std::filesystem::path& folder, bool force = false, std::optional<std::size_t> only = {});
/// Makes what is missing there: the first repetition of every point, then the second, so that a disturbance falls on all alike,
/// after a warm-up that is not counted. Each run adds a line to runs.jsonl when it ends (of one point alone: to its own file):
/// a study that is killed keeps them, and a line torn then is dropped. A point that fails is not repeated.
void run_points(const Study& study, Registry& registry, const std::filesystem::path& folder, const StudyWork& work = {}, const StudyListener& listen = {});
/// The points that have repetitions to come.
std::vector<std::size_t> unfinished_points(const Study& study, const std::filesystem::path& folder);
/// What the folder's runs say of each point, written as points.jsonl, table.csv, table.md and the charts.
std::vector<StudyResult> collect_study(const Study& study, const std::filesystem::path& folder);
/// The three above.
std::vector<StudyResult> run_study(const Study& study, Registry& registry, const std::filesystem::path& folder, bool force, const StudyListener& listen = {});
/// The folder has this study's runs but not its tables.
bool was_interrupted(const Study& study, Registry& registry, const std::filesystem::path& folder);

/// A study and its results as they are ranked.
struct StudyView {
    Study study;
    std::vector<StudyResult> results;
};
/// Points that differ in `worst_over` alone as one: the largest of the study's measure with the other measures of that run, CPU times
/// averaged over all of them; where one of them failed, that one. Without `worst_over` everything as it is.
StudyView worst_view(const Study& study, const std::vector<StudyResult>& results);

/// The cheapest point of a family that meets a target, in CPU time.
struct StudyReading {
    double target;
    std::string family;
    std::size_t point;
};
/// By target in the order of the study, then by cost. Families that do not meet a target have no reading.
std::vector<StudyReading> study_readings(const Study& study, const std::vector<StudyResult>& results);
/// 0.01 of a relative error as "1 %", else the number.
std::string target_text(const Study& study, double target);
/// What a result gives for a measure, by its name such as "errors.l2"; NaN where the point did not come to its end.
double measured(const StudyResult& result, const std::string& name);
/// Of all that a study may measure.
std::vector<std::string> measure_names();
/// Of an axis.
std::string measure_label(const std::string& name);
/// "diverged", for tables.
const char* status_name(StudyResult::Status status);
/// "2.4 ms", with two digits.
std::string time_text(double seconds);

/// The line of points.jsonl.
Json to_json(const Study& study, const StudyPoint& point, const StudyResult& result);
/// GitHub Markdown.
std::string study_markdown(const Study& study, const std::vector<StudyResult>& results);
std::string study_csv(const Study& study, const std::vector<StudyResult>& results);

}    // namespace sphonic
