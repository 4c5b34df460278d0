#include <algorithm>
#include <array>

#include "open_case.hpp"

namespace sphonic {
namespace {

constexpr std::string_view letters = "xyz";

/// Sources and references that are the same along every direction that they do not name.
constexpr std::array plane = {"plane_wave", "exact", "travelling_wave", "standing_wave", "plane_wave_front", "two_media"};

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; }

/// Calls visit(text, begin) for each name in an expression that is one letter long.
template <class Visit>
void for_letters(std::string& text, Visit visit) {
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((i == 0 || !in_word(text[i - 1])) && (i + 1 == text.size() || !in_word(text[i + 1]))) visit(text[i]);
}

/// All expressions of a case: initial values and regions.
template <class Visit>
void for_expressions(Json& document, Visit visit) {
    const auto region = [&](Json& object) {
        if (object.is_object() && object.contains("region") && object["region"].is_string()) visit(object["region"]);
    };
    for (const char* key : {"sources", "medium"})
        if (document.contains(key) && document[key].is_array())
            for (Json& object : document[key]) region(object);
    if (document.contains("reference")) region(document["reference"]);
    if (!document.contains("initial")) return;
    for (auto& [name, value] : document["initial"].items()) {
        if (value.is_string()) visit(value);
        for (Json& component : value)
            if (value.is_array() && component.is_string()) visit(component);
    }
}

/// All lists with an entry for each axis.
template <class Visit>
void for_vectors(Json& document, std::size_t d, Visit visit) {
    const auto of = [&](Json& object) {
        for (auto& [key, value] : object.items())
            if (value.is_array() && value.size() == d && key != "boundaries") visit(key, value);
    };
    if (document.contains("sources"))
        for (Json& source : document["sources"]) of(source);
    for (const char* key : {"reference", "initial"})
        if (document.contains(key)) of(document[key]);
}

/// True if both faces of an axis are periodic, or both rigid.
bool is_closed(const Json& document, int axis) {
    int periodic = 0, rigid = 0;
    for (const Json& boundary : document.value("boundaries", Json::array())) {
        const std::string face = boundary.value("face", ""), type = boundary.value("type", "");
        const int faces = face == "all" || face == std::string(1, letters[std::size_t(axis)]) ? 2 : !face.empty() && face[0] == letters[std::size_t(axis)] ? 1 : 0;
        periodic += type == "periodic" ? faces : 0;
        rigid += type == "rigid" ? faces : 0;
    }
    return periodic == 2 || rigid == 2;
}

bool plain(const Json& object) {
    return object.is_object() && std::ranges::find(plane, object.value("type", "")) != plane.end();
}

bool changes_nothing(Json& document, int axis) {
    const std::size_t a = std::size_t(axis), d = document["dimension"];
    const Json& particles = document["particles"];
    if (document.contains("obstacles") || particles.value("type", "") != "lattice" || particles.value("jitter", Json(0)) != 0 || !is_closed(document, axis)) return false;
    for (const Json& source : document.value("sources", Json::array()))
        if (!plain(source)) return false;
    if (document.contains("reference") && !plain(document["reference"])) return false;
    bool same = true;
    for_expressions(document, [&](Json& expression) {
        std::string text = expression;
        for_letters(text, [&](char& name) { same = same && name != letters[a] && name != 'r'; });
    });
    for_vectors(document, d, [&](const std::string& key, const Json& list) {
        const bool place = key == "phase_origin" || key == "interface" || key == "centre";
        same = same && (place || list[a] == 0 || list[a] == "0");
    });
    return same;
}

void drop(Json& document, int axis) {
    const std::size_t a = std::size_t(axis), d = document["dimension"];
    for_vectors(document, d, [&](const std::string&, Json& list) { list.erase(a); });
    for (const char* corner : {"lower", "upper"}) document["particles"][corner].erase(a);
    if (document.contains("output") && document["output"].contains("probes"))
        for (Json& probe : document["output"]["probes"]) probe.erase(a);
    for_expressions(document, [&](Json& expression) {
        std::string text = expression;
        for_letters(text, [&](char& name) {
            const std::size_t at = letters.find(name);
            if (at != letters.npos && at > a) name = letters[at - 1];
        });
        expression = text;
    });
    Json kept = Json::array();
    for (Json boundary : document["boundaries"]) {
        std::string face = boundary.value("face", "");
        const std::size_t at = face.empty() ? letters.npos : letters.find(face[0]);
        if (face != "all" && at == a) continue;
        if (face != "all" && at != letters.npos && at > a) boundary["face"] = std::string(1, letters[at - 1]) + face.substr(1);
        kept.push_back(boundary);
    }
    document["boundaries"] = kept;
    document["dimension"] = d - 1;
}

}    // namespace

std::vector<Decision> drop_axes(Json& document) {
    std::vector<Decision> decisions;
    for (int axis = int(document["dimension"]) - 1; axis >= 0 && document["dimension"] > 1; --axis) {
        if (!changes_nothing(document, axis)) continue;
        const double length = document["particles"]["upper"][std::size_t(axis)].get<double>() - document["particles"]["lower"][std::size_t(axis)].get<double>();
        drop(document, axis);
        char saves[80];
        std::snprintf(saves, sizeof saves, "all particles beside each other over %.4g m", length);
        decisions.push_back({"/dimension", document["dimension"], std::string("nothing changes along ") + letters[std::size_t(axis)] + ", and its faces let nothing in", saves});
    }
    return decisions;
}

}    // namespace sphonic
