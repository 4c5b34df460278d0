#include <algorithm>
#include <cmath>
#include <cstdio>

#include <sphonic/version.hpp>

#include "study_parts.hpp"

namespace sphonic {
namespace {

using Row = std::vector<std::string>;

std::string formatted(const char* format, double x) {
    char text[40];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

std::string with_digits(double x, const char* format) { return std::isfinite(x) ? formatted(format, x) : ""; }

/// The study's measure, then what its charts show besides CPU time.
std::vector<std::string> shown_measures(const Study& study) {
    std::vector<std::string> names{study.measure};
    for (const StudyChart& chart : study.charts)
        if (!std::ranges::count(names, chart.y)) names.push_back(chart.y);
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
    row.insert(row.end(), {"CPU [s]", "steps", "ns per particle-step"});
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
    row.push_back(with_digits(measured(result, "steps"), "%.0f"));
    row.push_back(with_digits(measured(result, "ns_per_particle_step"), "%.3g"));
    return row;
}

std::size_t width(const std::string& text) {
    return std::size_t(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));    // UTF-8
}

/// Columns of numbers stand to the right.
std::string markdown(std::vector<Row> rows, std::size_t labels) {
    std::vector<std::size_t> widths(rows[0].size(), 3);
    for (Row& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) {
            for (std::size_t at = 0; (at = row[c].find('|', at)) != std::string::npos; at += 2) row[c].insert(at, "\\");
            widths[c] = std::max(widths[c], width(row[c]));
        }
    std::string text;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < widths.size(); ++c) {
            const std::string space(widths[c] - width(rows[r][c]), ' ');
            text += "| " + (c < labels ? rows[r][c] + space : space + rows[r][c]) + " ";
        }
        text += "|\n";
        if (r > 0) continue;
        for (std::size_t c = 0; c < widths.size(); ++c)
            text += "| " + std::string(widths[c] - (c >= labels), '-') + (c < labels ? " " : ": ");
        text += "|\n";
    }
    return text;
}

std::string in_csv(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

std::string exact(double x) { return std::isfinite(x) ? Json(x).dump() : ""; }

}    // namespace

std::string readable(double x) {
    if (!std::isfinite(x)) return "";
    if (x == 0 || std::abs(x) >= 0.01) return formatted("%.4g", x);
    std::string text = formatted("%.3e", x);
    const std::size_t exponent = text.find("e-0");
    return exponent == std::string::npos ? text : text.erase(exponent + 2, 1);
}

std::string study_markdown(const Study& study, const std::vector<StudyResult>& results) {
    std::string text = "# " + study.title + "\n\n";
    if (!study.description.empty()) text += study.description + "\n\n";
    std::vector<Row> rows{heading(study)};
    for (std::size_t i = 0; i < results.size(); ++i) rows.push_back(line(study, study.points[i], results[i]));
    text += markdown(rows, study.vary.size() + has_family(study)) + "\n";
    for (std::size_t i = 0; i < results.size(); ++i)
        if (results[i].status != StudyResult::Status::done)
            text += "- " + study.points[i].full_name() + " " + status_name(results[i].status) + ": " + results[i].why +
                    "\n";
    if (!study.source.empty()) text += "Printed: " + study.source + ". ";
    return text + "CPU time is that of stepping. sphonic " + version() + " (" + commit() + ").\n";
}

std::string study_csv(const Study& study, const std::vector<StudyResult>& results) {
    std::string text;
    for (const StudyDimension& dimension : study.vary) text += in_csv(dimension.name) + ",";
    text += "family,status,printed,ratio";
    for (const Measure& m : measures()) text += std::string(",") + m.name;
    text += ",tier\n";
    for (std::size_t i = 0; i < results.size(); ++i) {
        const StudyPoint& point = study.points[i];
        for (const Json& label : point.labels) text += in_csv(label_text(label)) + ",";
        text += in_csv(point.family) + "," + status_name(results[i].status);
        text += "," + (point.printed ? exact(*point.printed) : "");
        text += "," + (point.printed ? exact(measured(results[i], study.measure) / *point.printed) : "");
        for (const Measure& m : measures()) text += "," + exact(measured(results[i], m.name));
        text += "," + in_csv(results[i].summary.tier) + "\n";
    }
    return text;
}

}    // namespace sphonic
