#include "study_interactive.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <sphonic/shown.hpp>

namespace sphonic::driver {
namespace {

namespace fs = std::filesystem;

/// In the order in which they need each other.
constexpr std::array scripts{"node_modules/vega/build/vega.min.js", "node_modules/vega-lite/build/vega-lite.min.js",
                             "node_modules/vega-embed/build/vega-embed.min.js", "page.js"};

/// Where all of them are: beside an installed driver, or in the source tree that this one was built from.
fs::path script_folder() {
    const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
    for (const fs::path& folder : {program.parent_path() / "share/sphonic/report", fs::path(SPHONIC_REPORT_SCRIPTS)}) {
        bool whole = true;
        for (const char* script : scripts) whole = whole && fs::exists(folder / script);
        if (whole) return folder;
    }
    return {};
}

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
    return text;
}

/// No string in it may end its element.
std::string inline_script(const std::string& text) { return "<script>" + replaced(text, "</script", "<\\/script") + "</script>\n"; }

std::string inline_data(const Json& data) {
    return "<script type=\"application/json\" id=\"study\">" + replaced(data.dump(-1, ' ', false, Json::error_handler_t::replace), "<", "\\u003c") + "</script>\n";
}

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json point_json(const Study& study, const StudyPoint& point, const StudyResult& result, const std::vector<std::string>& norms) {
    Json labels = Json::object(), changes = point.set;
    for (std::size_t d = 0; d < study.vary.size(); ++d) labels[study.vary[d].name] = point.labels[d];
    for (const Json& pointer : point.removed) changes[pointer.get<std::string>()] = "removed";
    for (const std::string& one : study.overrides) changes[one.substr(0, one.find('='))] = one.substr(one.find('=') + 1);
    const Summary& s = result.summary;
    Json json{{"name", point.name}, {"family", point.family}, {"labels", labels}, {"changes", changes}, {"case", point.file.string()}, {"cpu_s", s.cpu_s},
              {"spread", result.timing.runs > 1 ? shown(result.timing.low, 3) + " to " + shown(result.timing.high, 3) : ""}, {"doubt", result.timing.doubt},
              {"steps", s.steps}, {"particles", s.particles}, {"tier", s.tier.empty() ? s.method : s.tier},
              {"predicted_l2", optional_json(result.predicted_l2)}, {"predicted_cpu_s", optional_json(result.predicted_cpu_s)}};
    for (const std::string& norm : norms) {
        const double value = measured(result, norm);
        json[norm] = std::isfinite(value) ? Json(value) : Json(nullptr);
    }
    return json;
}

/// The study's measures first, then the norms of errors that are not among them.
std::vector<std::string> norms_of(const Study& study) {
    std::vector<std::string> norms{study.measure};
    norms.insert(norms.end(), study.also.begin(), study.also.end());
    for (const char* norm : {"errors.l2", "errors.rms", "errors.max", "errors.eps"})
        if (std::ranges::find(norms, norm) == norms.end()) norms.emplace_back(norm);
    return norms;
}

Json data_of(const Study& study, const std::vector<StudyResult>& results) {
    const std::vector<std::string> norms = norms_of(study);
    Json named = Json::array(), points = Json::array(), floors = Json::object();
    for (const StudyChart& chart : study.charts)
        if (chart.y_floor > 0) floors[chart.y] = chart.y_floor;
    for (const std::string& norm : norms) named.push_back({{"key", norm}, {"name", measure_label(norm)}});
    for (std::size_t i = 0; i < results.size(); ++i)
        if (results[i].status == StudyResult::Status::done) points.push_back(point_json(study, study.points[i], results[i], norms));
    return Json{{"norms", named}, {"floors", floors}, {"points", points}};
}

}    // namespace

std::string interactive_chart(const Study& study, const std::vector<StudyResult>& results) {
    const fs::path folder = script_folder();
    if (folder.empty()) return "";
    std::string text =
        "<section id=\"interactive\"><h2>Error against CPU time</h2>\n<p><label>Norm: <select id=\"norm\"></select></label></p>\n"
        "<p id=\"families\"></p>\n<div id=\"chart\"></div>\n<div id=\"told\" hidden></div>\n"
        "<p>Grey steps: the front of what is shown. Dashed: predicted. A family is hidden by its box.</p></section>\n";
    text += inline_data(data_of(study, results));
    for (const char* script : scripts) text += inline_script(content(folder / script));
    return text;
}

}    // namespace sphonic::driver
