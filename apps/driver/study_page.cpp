#include "study_page.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <sstream>

#include <sphonic/chart.hpp>
#include <sphonic/log.hpp>
#include <sphonic/result_folder.hpp>
#include <sphonic/shown.hpp>
#include <sphonic/version.hpp>

#include "html.hpp"
#include "study_interactive.hpp"

namespace sphonic::driver {
namespace {

namespace fs = std::filesystem;
using Rows = std::vector<std::vector<std::string>>;

std::string last_part(const std::string& measure) { return measure.substr(measure.find('.') + 1); }

std::string number(double x) { return std::isfinite(x) ? shown(x) : ""; }

/// As its own file would be; a page cannot link to it once it is sent somewhere else.
std::string csv_link(const std::string& csv) {
    static constexpr char digits[] = "0123456789ABCDEF";
    std::string text = "data:text/csv;charset=utf-8,";
    for (const char c : csv) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) || c == '-' || c == '.' || c == '_') text += c;
        else text += {'%', digits[byte >> 4], digits[byte & 15]};
    }
    return "<p><a download=\"table.csv\" href=\"" + text + "\">All values as CSV</a></p>\n";
}

std::string readings(const Study& study, const std::vector<StudyResult>& results) {
    const auto list = study_readings(study, results);
    if (list.empty()) return "";
    Rows rows{{"target", "cheapest of", "point", "CPU time", last_part(study.measure)}};
    for (const StudyReading& r : list)
        rows.push_back({target_text(study, r.target), study.points[r.point].family.empty() ? "all" : r.family, study.points[r.point].name,
                        time_text(results[r.point].summary.cpu_s), number(measured(results[r.point], study.measure))});
    return "<h2>What a target costs</h2>\n" + html_table(rows);
}

/// By error, with the points that no other beats marked; those without a number last.
std::string ranked(const Study& study, const std::vector<StudyResult>& results) {
    std::vector<std::size_t> order(results.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<double> cost, error;
    for (const StudyResult& result : results) cost.push_back(measured(result, "cpu_s")), error.push_back(measured(result, study.measure));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::isfinite(error[i]) ? error[i] : HUGE_VAL; });
    const auto front = pareto_front(cost, error);
    Rows rows{{"", "family", "point", last_part(study.measure)}};
    for (const std::string& name : study.also) rows[0].push_back(last_part(name));
    for (const char* title : {"CPU [s]", "quartiles [s]", "predicted l2", "predicted CPU [s]", "steps", "particles"}) rows[0].emplace_back(title);
    for (const std::size_t i : order) {
        const StudyResult& r = results[i];
        const bool done = r.status == StudyResult::Status::done;
        std::vector<std::string> row{std::ranges::count(front, i) ? "front" : "", study.points[i].family, study.points[i].name, done ? number(error[i]) : status_name(r.status)};
        for (const std::string& name : study.also) row.push_back(number(measured(r, name)));
        row.push_back((std::isfinite(cost[i]) ? shown(cost[i], 3) : "") + (r.timing.doubt.empty() ? "" : " ?"));
        row.push_back(r.timing.runs > 1 ? shown(r.timing.low, 3) + " to " + shown(r.timing.high, 3) : "");
        for (const auto& prediction : {r.predicted_l2, r.predicted_cpu_s}) row.push_back(prediction ? shown(*prediction, 3) : "");
        row.insert(row.end(), {done ? std::to_string(r.summary.steps) : "", done ? std::to_string(r.summary.particles) : ""});
        rows.push_back(row);
    }
    return "<h2>Ranked by error</h2>\n<p>front: no other point is both cheaper and more accurate. ?: the time is in doubt.</p>\n<div class=\"ranked\">" + html_table(rows) + "</div>\n";
}

/// Points that failed, and, folded up where they are many, those whose time is in doubt.
std::string notes(const Study& study, const std::vector<StudyResult>& results) {
    constexpr long few = 10;
    std::string failed, doubts;
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (!results[i].why.empty()) failed += "<li>" + escaped(study.points[i].full_name() + " " + status_name(results[i].status) + ": " + results[i].why) + "</li>\n";
        if (!results[i].timing.doubt.empty()) doubts += "<li>" + escaped(study.points[i].full_name() + ", time in doubt: " + results[i].timing.doubt) + "</li>\n";
    }
    const auto list = [](const std::string& items) { return items.empty() ? "" : "<ul>\n" + items + "</ul>\n"; };
    const long many = std::ranges::count_if(results, [](const StudyResult& r) { return !r.timing.doubt.empty(); });
    if (many > few) doubts = "<details><summary>Times in doubt: " + std::to_string(many) + " of " + std::to_string(results.size()) + " points</summary>\n" + list(doubts) + "</details>\n";
    else doubts = list(doubts);
    return failed.empty() && doubts.empty() ? "" : "<h2>Points to know about</h2>\n" + list(failed) + doubts;
}

std::string charts(const Study& study, const fs::path& folder) {
    std::string text;
    for (const StudyChart& chart : study.charts) {
        const std::string svg = inline_svg(folder / (chart.name + ".svg"));
        text += svg.empty() ? "<p>" + escaped(chart.title) + ": no picture, as gnuplot is not installed.</p>\n" : "<figure>" + svg + "</figure>\n";
    }
    return text;
}

constexpr const char* style =
    "<style>td:nth-child(2),td:nth-child(3),th:nth-child(2),th:nth-child(3){text-align:left}table{font-size:13px}figure{margin:1em 0;break-inside:avoid}"
    "tr{break-inside:avoid}h2{break-after:avoid}#chart{width:100%}#families label{margin-right:1.2em;white-space:nowrap}.mark{margin:0 .3em;font-family:DejaVu Sans,sans-serif}"
    ".ranked td:nth-child(n+4){white-space:nowrap}#told{position:absolute;z-index:9;max-width:34em;background:#fff;border:1px solid #888;padding:.4em .7em;font-size:13px;"
    "box-shadow:0 2px 6px #0003;overflow-wrap:anywhere}@media print{#interactive{display:none}body{max-width:none}}</style>\n";

}    // namespace

void write_study_page(const Study& whole, const std::vector<StudyResult>& all, const fs::path& folder) {
    const auto [study, results] = worst_view(whole, all);
    const std::string interactive = interactive_chart(study, results);
    if (interactive.empty())
        log::warn((folder / "report.html").string() + ": has no interactive chart, as its scripts are not installed. Run npm ci --ignore-scripts in apps/report");
    const std::string missing = "<p>The interactive chart is left out: the scripts that draw it were not installed.</p>\n";
    std::string body = style + ("<h1>" + escaped(study.title) + "</h1>\n<p>" + escaped(study.description) + "</p>\n");
    body += readings(study, results) + (interactive.empty() ? missing : interactive) + charts(study, folder) + ranked(study, results) + csv_link(study_csv(whole, all));
    body += notes(whole, all);
    if (!study.worst_over.empty()) body += "<p>A point is the worst over " + escaped(study.worst_over) + "; its time is the mean over it.</p>\n";
    const std::string times = study.repeat > 1 ? "medians of " + std::to_string(study.repeat) + " runs, in turn with those of the other points" : std::string("one run each");
    body += "<p>CPU time is that of stepping, " + times + ". sphonic " + version() + " (" + commit() + ").</p>\n";
    write_file(folder / "report.html", html_page(study.title, body));
}

}    // namespace sphonic::driver
