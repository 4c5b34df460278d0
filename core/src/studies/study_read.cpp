#include <algorithm>

#include <sphonic/error.hpp>

#include "study_parts.hpp"
#include "study_reader.hpp"

namespace fs = std::filesystem;

namespace sphonic {
namespace {

bool is_label(const Json& value) { return value.is_number() || value.is_string() || value.is_boolean(); }

fs::path read_scene(Section& section, const fs::path& file) {
    const std::string name = section.text("case", "");
    return name.empty() ? fs::path() : (file.parent_path() / name).lexically_normal();
}

StudyValue read_value(Section section, const fs::path& file) {
    const Json& label = section.need("label", "Give the name of this value in tables and charts");
    if (!is_label(label)) section.fail("label", shown(label) + " is no label", "Give a string or a number");
    StudyValue value{.label = label,
                     .family = section.text("family", ""),
                     .scene = read_scene(section, file),
                     .remove = {},
                     .set = {}};
    if (section.find("remove"))
        for (const Json& pointer : need_list(section, "remove", "Give a list of JSON pointers")) {
            if (!pointer.is_string())
                section.fail("remove", shown(pointer) + " is not a string",
                             "Give JSON pointers such as \"/viscosity\"");
            value.remove.push_back(pointer);
        }
    if (const Json* set = section.find("set")) {
        if (!set->is_object()) section.fail("set", shown(*set) + " is not an object", "Write { \"/pointer\": value }");
        for (const auto& [pointer, setting] : set->items()) value.set.emplace_back(pointer, setting);
    }
    section.finish();
    return value;
}

void add_value(StudyDimension& dimension, const Section& section, const Json& given, const std::vector<std::string>& pointers,
               const fs::path& file) {
    const std::string key = "values/" + std::to_string(dimension.values.size());
    const std::string at = section.pointer() + "/" + key;
    StudyValue value;
    if (given.is_object())
        value = read_value(Section(given, section.file(), at), file);
    else if (!is_label(given))
        throw Error(Fault::input, section.file() + ": " + at, shown(given) + " is no value",
                    "Give a number, a string or { \"label\": ... }");
    else if (pointers.empty())
        throw Error(Fault::input, section.file() + ": " + at, shown(given) + " goes nowhere",
                    "Give the dimension a \"pointer\", or write { \"label\": ..., \"set\": { \"/pointer\": value } }");
    else {
        value = {.label = given, .family = {}, .scene = {}, .remove = {}, .set = {}};
        for (const std::string& pointer : pointers) value.set.emplace_back(pointer, given);
    }
    for (const StudyValue& other : dimension.values)
        if (other.family == value.family && label_text(other.label) == label_text(value.label))
            throw Error(Fault::input, section.file() + ": " + at,
                        "the label \"" + label_text(value.label) + "\" is given twice", "Label each value differently");
    dimension.values.push_back(std::move(value));
}

/// One, or several that get the same value.
std::vector<std::string> read_pointers(Section& section) {
    const Json* member = section.find("pointer");
    if (!member) return {};
    if (!member->is_array()) return {section.text("pointer", "")};
    std::vector<std::string> pointers;
    for (const Json& pointer : need_list(section, "pointer", "Give JSON pointers")) {
        if (!pointer.is_string()) section.fail("pointer", shown(pointer) + " is not a string", "Give JSON pointers such as \"/kernel/h\"");
        pointers.push_back(pointer);
    }
    return pointers;
}

StudyDimension read_dimension(const Study& study, Section section) {
    StudyDimension dimension{.name = need_text(section, "name", "Name the dimension"), .values = {}};
    const auto same = [&](const auto& other) { return other.name == dimension.name; };
    if (std::ranges::any_of(study.vary, same))
        section.fail("name", "there are two dimensions \"" + dimension.name + "\"", "Name each differently");
    if (dimension.name == "family" || dimension.name[0] == '/' || std::ranges::any_of(measures(), same))
        section.fail("name", "\"" + dimension.name + "\" is not free",
                     "Choose a name that is no measure, no pointer and not \"family\"");
    const std::vector<std::string> pointers = read_pointers(section);
    for (const Json& given : need_list(section, "values", "Give the values in a list"))
        add_value(dimension, section, given, pointers, study.file);
    if (read_flag(section, "family"))
        for (StudyValue& value : dimension.values)
            if (value.family.empty()) value.family = named_label(dimension.name, value.label);
    section.finish();
    return dimension;
}

}    // namespace

const Json& need_list(Section& section, const std::string& key, const std::string& remedy) {
    const Json& list = section.need(key, remedy);
    if (!list.is_array() || list.empty()) section.fail(key, shown(list) + " is not a list with entries", remedy);
    return list;
}

std::string need_text(Section& section, const std::string& key, const std::string& remedy) {
    section.need(key, remedy);
    const std::string text = section.text(key, "");
    if (text.empty()) section.fail(key, "the text is empty", remedy);
    return text;
}

Study load_study(const fs::path& file, const std::vector<std::string>& overrides) {
    const Json document = read_json(file);
    Section root(document, file.string(), "");
    root.pass_over_schema();
    Study study;
    study.file = file;
    study.scene = read_scene(root, file);
    study.overrides = overrides;
    study.title = root.text("title", file.stem().string());
    study.description = root.text("description", "");
    read_measures(study, root);
    study.repeat = read_repeat(root);
    if (root.find("cutoff")) study.cutoff = positive(root, "cutoff", *root.find("cutoff"), "Give the seconds of CPU time after which a run is given up");
    read_targets(study, root);
    const Json& vary = need_list(root, "vary", "Give [ { \"name\": ..., \"pointer\": ..., \"values\": [...] } ]");
    for (std::size_t i = 0; i < vary.size(); ++i)
        study.vary.push_back(read_dimension(study, {vary[i], root.file(), "/vary/" + std::to_string(i)}));
    read_worst_over(study, root);
    make_points(study);
    if (root.find("printed")) read_printed(study, root.child("printed", ""));
    if (root.find("charts")) read_charts(study, need_list(root, "charts", "Give a list of charts"));
    root.finish();
    return study;
}

}    // namespace sphonic
