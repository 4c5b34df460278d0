#include "open_case.hpp"

#include <sphonic/error.hpp>

namespace sphonic {
namespace {

bool is_auto(const Json& object, const char* key) { return !object.contains(key) || object[key] == "auto"; }

void take_out(Json& object, const char* key) {
    if (object.contains(key)) object.erase(key);
}

[[noreturn]] void refuse(const std::string& file, const std::string& pointer, const std::string& problem, const std::string& remedy) {
    throw Error(Fault::input, file + ": " + pointer, problem, remedy);
}

bool is_list_of_numbers(const Json& list, std::size_t n) {
    if (!list.is_array() || list.size() != n) return false;
    for (const Json& value : list)
        if (!value.is_number()) return false;
    return true;
}

void require_box(const Json& document, const std::string& file) {
    if (!document.is_object()) refuse(file, "/", "it is not an object", "Write { ... }");
    const Json d = document.value("dimension", Json());
    if (!d.is_number_integer() || d < 1 || d > 3) refuse(file, "/dimension", "planning needs it", "Give 1, 2 or 3");
    const Json particles = document.value("particles", Json());
    if (!particles.is_object()) refuse(file, "/particles", "planning needs the box", "Give { \"type\": \"lattice\", \"lower\": [...], \"upper\": [...] }");
    for (const char* corner : {"lower", "upper"})
        if (!is_list_of_numbers(particles.value(corner, Json()), d.get<std::size_t>()))
            refuse(file, std::string("/particles/") + corner, "is not a list of " + d.dump() + " numbers", "Give the corner of the box");
}

/// Spacings of the media's own are taken out where they are "auto", and all of them with `free`.
void open_spacings(OpenCase& open, bool free) {
    if (!open.document.contains("medium") || !open.document["medium"].is_array()) return;
    bool given = false, automatic = false;
    for (Json& medium : open.document["medium"]) {
        if (!medium.is_object() || !medium.contains("dx")) continue;
        (free || medium["dx"] == "auto" ? automatic : given) = true;
        if (free || medium["dx"] == "auto") medium.erase("dx");
    }
    open.own_spacings = !given && (open.spacing || automatic);
}

/// The integrator's type and step may be open apart.
void open_integrator(OpenCase& open, bool free) {
    Json& document = open.document;
    open.integrator = free || is_auto(document, "integrator") || (document["integrator"].is_object() && is_auto(document["integrator"], "type"));
    if (open.integrator) {
        open.step = true;
        take_out(document, "integrator");
        return;
    }
    Json& integrator = document["integrator"];
    if (!integrator.is_object()) return;
    open.step = true;
    for (const char* key : {"dt", "courant", "safety"})
        if (is_auto(integrator, key))
            take_out(integrator, key);
        else
            open.step = false;
}

}    // namespace

double OpenCase::length(int axis) const {
    const Json& particles = document["particles"];
    const std::size_t a = std::size_t(axis);
    return particles["upper"][a].get<double>() - particles["lower"][a].get<double>();
}

bool OpenCase::whole(int axis) const {
    if (!document.contains("boundaries") || !document["boundaries"].is_array()) return false;
    for (const Json& boundary : document["boundaries"]) {
        const std::string face = boundary.is_object() ? boundary.value("face", Json("")).dump() : "";
        if (face == "\"all\"" || (face.size() > 2 && face[1] == "xyz"[axis])) return true;
    }
    return false;
}

bool several_media(const OpenCase& open) { return open.document.contains("medium") && open.document["medium"].is_array() && open.document["medium"].size() > 1; }

bool off_sites(const OpenCase& open) {
    const Json& particles = open.document["particles"];
    return particles["type"] != "lattice" || particles.value("jitter", Json(0)) != 0;
}

bool displaced(const OpenCase& open) { return off_sites(open) || open.document.contains("obstacles"); }

double speed(const Json& medium) { return medium.value("c0", 1.0); }

OpenCase opened(const Json& document, const std::string& file, bool free) {
    require_box(document, file);
    OpenCase open{.document = document, .file = file};
    Json& d = open.document;
    take_out(d, "accuracy");
    open.equations = free || is_auto(d, "equations");
    open.kernel = free || (is_auto(d, "kernel") && !d.contains("kernels"));
    open.method = free || (d.contains("method") ? d["method"] == "auto" : open.equations);
    open.spacing = free || is_auto(d["particles"], "dx");
    open_spacings(open, free);
    open.viscosity = free && d.contains("viscosity");
    open.attenuation = free;
    open.precision = free || d.value("precision", Json()) == "auto";
    if (open.equations) take_out(d, "equations");
    if (open.kernel) take_out(d, "kernel"), take_out(d, "kernels");
    if (open.method) take_out(d, "method");
    if (open.spacing) take_out(d["particles"], "dx");
    if (open.viscosity) take_out(d, "viscosity");
    if (free) take_out(d, "dissipation");
    if (open.precision) take_out(d, "precision");
    open.motion = free && d["particles"].value("motion", Json("auto")) == "lagrangian";
    open.active = free && d.value("active", Json("auto")) == "all";
    if (open.active) take_out(d, "active");
    if (free || is_auto(d["particles"], "motion")) take_out(d["particles"], "motion");
    if (free) take_out(d["particles"], "neighbours");
    if (!d["particles"].contains("type")) d["particles"]["type"] = "lattice";
    open_integrator(open, free);
    return open;
}

}    // namespace sphonic
