#include <sphonic/error.hpp>
#include <sphonic/nearest.hpp>

#include <map>

#include "study_parts.hpp"

namespace sphonic {
namespace {

constexpr std::size_t most_points = 10000;

using Choice = std::vector<const StudyValue*>;    ///< one per dimension

void remove_at(Json& root, const std::string& pointer) {
    std::string near;
    try {
        const Json::json_pointer at(pointer);
        if (!at.empty() && root.contains(at)) {
            Json& parent = root.at(at.parent_pointer());
            if (parent.is_array())
                parent.erase(std::stoul(at.back()));
            else
                parent.erase(at.back());
            return;
        }
        std::vector<std::string> names;
        if (!at.empty())
            for (const auto& [key, member] : root.at(at.parent_pointer()).items())
                names.push_back((at.parent_pointer() / key).to_string());
        near = nearest(pointer, names);
    } catch (const Json::exception&) {    // not a pointer, or its parent is missing too
    }
    throw Error(Fault::input, "remove", "\"" + pointer + "\" is not in the case",
                near.empty() ? "Check the pointer" : "Did you mean \"" + near + "\"?");
}

/// The case of a choice as its file has it.
std::filesystem::path scene_of(const Study& study, const Choice& choice) {
    std::filesystem::path scene = study.scene;
    for (const StudyValue* value : choice)
        if (!value->scene.empty()) scene = value->scene;
    if (scene.empty()) throw Error(Fault::input, "case", "is missing", "Give \"case\" in the study or in the value");
    return scene;
}

void apply(const Study& study, const Choice& choice, StudyPoint& point) {
    for (const StudyValue* value : choice) {
        for (const std::string& pointer : value->remove) {
            remove_at(point.document, pointer);
            point.removed.push_back(pointer);
            point.set.erase(pointer);    // by an earlier dimension
        }
        for (const auto& [pointer, setting] : value->set) {
            set_at(point.document, pointer, setting, "set");
            point.set[pointer] = setting;
        }
    }
    for (const std::string& assignment : study.overrides) set_at(point.document, assignment);
}

StudyPoint labelled(const Study& study, const Choice& choice) {
    StudyPoint point;
    for (const StudyValue* value : choice) {
        point.labels.push_back(value->label);
        if (!value->family.empty()) point.family = value->family;
    }
    point.name = joined_labels(study, point.labels);
    return point;
}

/// The `index`-th choice: a number whose last digit varies fastest.
Choice chosen(const Study& study, std::size_t index) {
    Choice choice(study.vary.size());
    for (std::size_t d = choice.size(); d-- > 0;) {
        const auto& values = study.vary[d].values;
        choice[d] = &values[index % values.size()];
        index /= values.size();
    }
    return choice;
}

}    // namespace

std::string label_text(const Json& label) { return label.is_string() ? label.get<std::string>() : label.dump(); }

std::string place_name(const std::string& place) { return place.starts_with('/') ? place.substr(place.rfind('/') + 1) : place; }

std::string named_label(const std::string& place, const Json& label) { return (label.is_string() ? "" : place_name(place) + " = ") + label_text(label); }

std::string joined_labels(const Study& study, const std::vector<Json>& labels, const std::string& but) {
    std::string text;
    for (std::size_t d = 0; d < labels.size(); ++d) {
        if (study.vary[d].values.size() < 2 || study.vary[d].name == but) continue;
        text += (text.empty() ? "" : ", ") + named_label(study.vary[d].name, labels[d]);
    }
    return text;
}

Json at_place(const Study& study, const StudyPoint& point, const std::string& place) {
    if (place == "family") return point.family;
    for (std::size_t d = 0; d < study.vary.size(); ++d)
        if (study.vary[d].name == place) return point.labels[d];
    const Json::json_pointer at(place);
    return point.document.contains(at) ? point.document.at(at) : Json(nullptr);
}

std::string point_place(const Study& study, std::size_t index, std::size_t total, const std::string& name) {
    return study.file.string() + ": point " + std::to_string(index + 1) + " of " + std::to_string(total) +
           (name.empty() ? "" : " (" + name + ")");
}

void make_points(Study& study) {
    std::size_t total = 1;
    for (const StudyDimension& dimension : study.vary)
        if ((total *= dimension.values.size()) > most_points)
            throw Error(Fault::input, study.file.string() + ": /vary",
                        "this makes more than " + std::to_string(most_points) + " points", "Vary less in one study");
    std::map<std::filesystem::path, Json> cases;
    for (std::size_t i = 0; i < total; ++i) {
        const Choice choice = chosen(study, i);
        StudyPoint point = labelled(study, choice);
        try {
            point.file = scene_of(study, choice);
            if (!cases.contains(point.file)) cases[point.file] = read_json(point.file);
            point.document = cases[point.file];
            apply(study, choice, point);
        } catch (const Error& e) {
            throw Error(e.fault, point_place(study, i, total, point.full_name()), e.what());
        }
        study.points.push_back(std::move(point));
    }
}

}    // namespace sphonic
