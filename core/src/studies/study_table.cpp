#include <algorithm>
#include <cmath>
#include <cstdio>

#include <sphonic/version.hpp>

#include "study_parts.hpp"

namespace sphonic {
namespace {

using Row = std::vector<std::string>;

/// The study's measures, then what its charts show besides CPU time.
std::vector<std::string> shown_measures(const Study& study) {
    std::vector<std::string> names{study.measure};
    names.insert(names.end(), study.also.begin(), study.also.end());
    for (const StudyChart& chart : study.charts) {
        const std::string& drawn = chart.type == StudyChart::Type::map ? chart.measure : chart.y;
        if (!std::ranges::count(names, drawn)) names.push_back(drawn);
    }
    for (const char* given : {"cpu_s", "steps", "ns_per_particle_step"}) std::erase(names, given);
    return names;
}

bool has_printed(const Study& study) {
    return std::ranges::any_of(study.points, [](const StudyPoint& point) { return point.printed.has_value(); });
}

bool has_family(const Study& study) {
    return std::ranges::any_of(study.points, [](const StudyPoint& point) { return !point.family.empty(); });
}

Row heading(const Study& study) {
    Row row;
    if (has_family(study)) row.push_back("family");
    for (const StudyDimension& dimension : study.vary) row.push_back(dimension.name);
    for (const std::string& name : shown_measures(study)) row.push_back(name.substr(name.find('.') + 1));
    if (has_printed(study)) row.insert(row.end(), {"printed", "ours / printed"});
    row.push_back("CPU [s]");
    if (study.repeat > 1) row.push_back("quartiles [s]");
    row.insert(row.end(), {"steps", "ns per particle-step"});
    return row;
}

Row line(const Study& study, const StudyPoint& point, const StudyResult& result) {
    Row row;
    if (has_family(study)) row.push_back(point.family);
    for (const Json& label : point.labels) row.push_back(label_text(label));
    const std::size_t first = row.size();
    for (const std::string& name : shown_measures(study)) row.push_back(readable(measured(result, name)));
    if (result.status != StudyResult::Status::done) row[first] = status_name(result.status);
    if (has_printed(study)) {
        row.push_back(point.printed ? readable(*point.printed) : "");
        row.push_back(point.printed ? with_digits(measured(result, study.measure) / *point.printed, "%.3f") : "");
    }
    row.push_back(with_digits(measured(result, "cpu_s"), "%.3g"));
    const StudyTiming& timing = result.timing;
    if (study.repeat > 1) row.push_back(timing.runs ? formatted("%.3g", timing.low) + " to " + formatted("%.3g", timing.high) : "");
    if (!timing.doubt.empty()) row[row.size() - 1 - (study.repeat > 1)] += " ?";
    row.push_back(with_digits(measured(result, "steps"), "%.0f"));
    row.push_back(with_digits(measured(result, "ns_per_particle_step"), "%.3g"));
    return row;
}

std::string in_csv(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

std::string exact(double x) { return std::isfinite(x) ? Json(x).dump() : ""; }

/// How the times were taken, and which to doubt.
std::string timing_note(const Study& study, const std::vector<StudyResult>& results) {
    std::string doubts;
    for (std::size_t i = 0; i < results.size(); ++i)
        if (!results[i].timing.doubt.empty()) doubts += "- " + study.points[i].full_name() + ": " + results[i].timing.doubt + "\n";
    std::string text = "CPU time is that of stepping";
    if (study.repeat > 1) text += ", the median of " + std::to_string(study.repeat) + " runs in turn with those of the other points";
    return text + (doubts.empty() ? ". " : ". Times marked ? are in doubt:\n\n" + doubts + "\n");
}

}    // namespace

std::string study_markdown(const Study& study, const std::vector<StudyResult>& results) {
    std::string text = "# " + study.title + "\n\n";
    if (!study.description.empty()) text += study.description + "\n\n";
    if (!study.worst_over.empty()) text += "Each row is the worst over " + study.worst_over + "; times are means over it.\n\n";
    std::vector<Row> rows{heading(study)};
    for (std::size_t i = 0; i < results.size(); ++i) rows.push_back(line(study, study.points[i], results[i]));
    text += markdown_table(rows, study.vary.size() + has_family(study)) + "\n";
    for (std::size_t i = 0; i < results.size(); ++i)
        if (results[i].status != StudyResult::Status::done)
            text += "- " + study.points[i].full_name() + " " + status_name(results[i].status) + ": " + results[i].why + "\n";
    if (!study.source.empty()) text += "Printed: " + study.source + ". ";
    return text + readings_markdown(study, results) + timing_note(study, results) + "sphonic " + version() + " (" + commit() + ").\n";
}

std::string study_csv(const Study& study, const std::vector<StudyResult>& results) {
    std::string text;
    for (const StudyDimension& dimension : study.vary) text += in_csv(dimension.name) + ",";
    text += "family,status,printed,ratio,runs,cpu_low_s,cpu_high_s,timing_doubt,predicted_l2,predicted_cpu_s";
    for (const Measure& m : measures()) text += std::string(",") + m.name;
    text += ",tier\n";
    for (std::size_t i = 0; i < results.size(); ++i) {
        const StudyPoint& point = study.points[i];
        for (const Json& label : point.labels) text += in_csv(label_text(label)) + ",";
        text += in_csv(point.family) + "," + status_name(results[i].status);
        text += "," + (point.printed ? exact(*point.printed) : "");
        text += "," + (point.printed ? exact(measured(results[i], study.measure) / *point.printed) : "");
        const StudyTiming& timing = results[i].timing;
        text += "," + std::to_string(timing.runs) + "," + (timing.runs ? exact(timing.low) + "," + exact(timing.high) : ",") + "," + in_csv(timing.doubt);
        for (const auto& prediction : {results[i].predicted_l2, results[i].predicted_cpu_s}) text += "," + (prediction ? exact(*prediction) : "");
        for (const Measure& m : measures()) text += "," + exact(measured(results[i], m.name));
        text += "," + in_csv(results[i].summary.tier) + "\n";
    }
    return text;
}

}    // namespace sphonic
