#pragma once
/// The parts of a study: places and measures by name, points, tables, charts.

#include <span>

#include <sphonic/chart.hpp>
#include <sphonic/study.hpp>

namespace sphonic {

/// A number that a run gives.
struct Measure {
    const char *name, *label;
    double (*of)(const Summary&);
    bool of_reference = false;    ///< needs one
};

std::span<const Measure> measures();
/// `name` is one of them.
const Measure& measure(const std::string& name);

/// What stands at a place of a point; null where there is nothing.
Json at_place(const Study& study, const StudyPoint& point, const std::string& place);
/// A label as people read it.
std::string label_text(const Json& label);
/// The same where its dimension is not seen: "alpha = 0.03"; a text speaks for itself.
std::string named_label(const std::string& place, const Json& label);
/// What a dimension, or the last member of a JSON pointer, is called.
std::string place_name(const std::string& place);
/// The labels of dimensions with several values, but for one dimension, with commas.
std::string joined_labels(const Study& study, const std::vector<Json>& labels, const std::string& but = {});

std::string formatted(const char* format, double x);
/// Empty where there is no number.
std::string with_digits(double x, const char* format);
/// GitHub Markdown of rows, the first of them headings; columns after the `labels` first stand to the right.
std::string markdown_table(std::vector<std::vector<std::string>> rows, std::size_t labels);
/// What each target costs, as Markdown; empty where no point meets any.
std::string readings_markdown(const Study& study, const std::vector<StudyResult>& results);

/// Four digits, small numbers as 2.574e-4; empty where there is no number.
std::string readable(double x);

/// Crosses the dimensions and makes each point's case.
void make_points(Study& study);

/// "STUDY: point 3 of 20 (NAME)", for messages.
std::string point_place(const Study& study, std::size_t index, std::size_t total, const std::string& name);

/// Cells over two dimensions: the chart's measure, and beside it CPU time.
Chart map_chart(const Study& study, const StudyChart& wish, const std::vector<StudyResult>& results);
Chart study_chart(const Study& study, const StudyChart& wish, const std::vector<StudyResult>& results);

}    // namespace sphonic
