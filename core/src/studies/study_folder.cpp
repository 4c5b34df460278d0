#include "study_folder.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <unistd.h>

#include <sphonic/error.hpp>
#include <sphonic/log.hpp>
#include <sphonic/result_folder.hpp>
#include <sphonic/version.hpp>

#include "study_parts.hpp"
#include "study_runs.hpp"

namespace fs = std::filesystem;

namespace sphonic {
namespace {

constexpr const char* identity_file = "identity.json";

/// FNV-1a in 64 bits.
std::string digest(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text) hash = (hash ^ std::uint8_t(c)) * 0x100000001b3;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    return digits;
}

bool needs_reference(const Study& study) {
    const auto of_reference = [](const std::string& name) { return measure(name).of_reference; };
    const auto draws_one = [&](const StudyChart& chart) { return of_reference(chart.type == StudyChart::Type::map ? chart.measure : chart.y); };
    return of_reference(study.measure) || std::ranges::any_of(study.also, of_reference) || std::ranges::any_of(study.charts, draws_one);
}

/// The point's case must be readable before the first one runs.
Json identity_of(const Study& study, std::size_t index, Registry& registry) {
    const StudyPoint& point = study.points[index];
    try {
        const Case scene = load_case(point.document, point.file, registry);
        if (needs_reference(study) && !scene.reference)
            throw Error(Fault::input, scene.file + ": /reference", "is missing, so the study can measure no error", "Give one, or choose another measure");
        Json whole = *scene.resolved;
        whole.erase("provenance");
        return {{"name", point.full_name()}, {"case", digest(whole.dump(-1, ' ', false, Json::error_handler_t::replace))}};
    } catch (const Error& e) {
        throw Error(e.fault, point_place(study, index, study.points.size(), point.full_name()), e.what());
    }
}

/// Whole or not at all, even where several programs write it at a time.
void write_whole(const fs::path& file, const std::string& text) {
    const fs::path part = file.string() + ".part" + std::to_string(getpid());
    write_file(part, text);
    fs::rename(part, file);
}

/// `replace` empties a folder that holds a study, but no other.
void make_folder(const fs::path& folder, bool replace) {
    std::error_code failed;
    if (fs::exists(folder)) {
        const bool study = fs::is_directory(folder) && (fs::is_empty(folder) || fs::exists(folder / identity_file) || fs::exists(folder / "points.jsonl"));
        if (!study) throw Error(Fault::io, folder.string(), "holds something other than a study", "Give another --out");
        if (replace) fs::remove_all(folder, failed);
    }
    if (!failed) fs::create_directories(folder, failed);
    if (failed) throw Error(Fault::io, folder.string(), "cannot be created: " + failed.message(), "Check space and permissions");
}

}    // namespace

Json identity(const Study& study, Registry& registry, std::optional<std::size_t> only) {
    Json points = Json::array();
    for (std::size_t i = 0; i < study.points.size(); ++i) points.push_back(only && *only != i ? Json(nullptr) : identity_of(study, i, registry));
    return {{"study", study.file.string()}, {"title", study.title}, {"sphonic", std::string(version()) + " (" + commit() + ")"},
            {"threads", study.threads}, {"cutoff", study.cutoff ? Json(*study.cutoff) : Json(nullptr)}, {"points", points}};
}

std::string difference(const Study& study, const Json& ours, const fs::path& folder) {
    if (!fs::exists(folder / identity_file)) return std::string("it has no ") + identity_file;
    const Json theirs = read_json(folder / identity_file);
    const Json there = theirs.value("points", Json::array());
    for (std::size_t i = 0; i < std::min(study.points.size(), there.size()); ++i)
        if (!ours.at("points")[i].is_null() && there[i] != ours.at("points")[i]) return point_place(study, i, study.points.size(), study.points[i].full_name()) + " is another case there";
    if (there.size() != study.points.size()) return "it has " + std::to_string(there.size()) + " points, " + study.file.string() + " has " + std::to_string(study.points.size());
    for (const char* key : {"threads", "cutoff"})
        if (theirs.value(key, Json()) != ours.at(key)) return std::string(key) + " is " + theirs.value(key, Json()).dump() + " there and " + ours.at(key).dump() + " here";
    return "";
}

void open_study(const Study& study, Registry& registry, const fs::path& folder, bool force, std::optional<std::size_t> only) {
    const bool fresh = force || !fs::exists(folder) || (fs::is_directory(folder) && fs::is_empty(folder));
    const Json ours = identity(study, registry, fresh ? std::nullopt : only);
    make_folder(folder, force);
    if (fresh) return write_whole(folder / identity_file, json_text(ours));
    if (const std::string other = difference(study, ours, folder); !other.empty())
        throw Error(Fault::io, folder.string(), "holds another study: " + other, "Give --force to replace it, or another --out");
    if (const Json theirs = read_json(folder / identity_file); theirs.at("sphonic") != ours.at("sphonic"))
        log::warn(folder.string() + ": continues what sphonic " + theirs.at("sphonic").get<std::string>() + " began; times of two programs do not compare");
}

bool was_interrupted(const Study& study, Registry& registry, const fs::path& folder) {
    return fs::exists(folder / identity_file) && !fs::exists(folder / "points.jsonl") && difference(study, identity(study, registry, {}), folder).empty();
}

void write_tables(const Study& study, const std::vector<StudyResult>& results, const fs::path& folder) {
    std::string lines;
    for (std::size_t i = 0; i < results.size(); ++i)
        lines += to_json(study, study.points[i], results[i]).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    bool drawn = true;
    const StudyView worst = worst_view(study, results);
    for (const StudyChart& wish : study.charts) {
        const bool each = study.worst_over.empty() || wish.x == study.worst_over || wish.group == study.worst_over;
        drawn &= draw(each ? study_chart(study, wish, results) : study_chart(worst.study, wish, worst.results), folder / wish.name);
    }
    write_whole(folder / "table.csv", study_csv(study, results));
    write_whole(folder / "table.md", study_markdown(worst.study, worst.results));
    write_whole(folder / "points.jsonl", lines);
    if (!drawn) log::warn(folder.string() + ": gnuplot is not installed, so the charts are left as scripts (.gp)");
}

}    // namespace sphonic
