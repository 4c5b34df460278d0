#include <sphonic/equations.hpp>

#include <algorithm>

#include <sphonic/error.hpp>
#include <sphonic/nearest.hpp>
#include <sphonic/parameters.hpp>

#include "equation_reader.hpp"

#ifndef SPHONIC_EQUATIONS_DIR
#error "SPHONIC_EQUATIONS_DIR names the folder of equation presets"
#endif

namespace fs = std::filesystem;

namespace sphonic {
namespace {

/// A preset is a JSON file with exactly the content of "equations".
Json load_preset(const std::string& name, const Case& scene, const std::string& place) {
    const fs::path folder = fs::path(scene.file).parent_path();
    const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
    std::vector<fs::path> folders{folder / "equations", folder / "../equations", program / "../share/sphonic/equations", SPHONIC_EQUATIONS_DIR};
    std::vector<std::string> known;
    for (const fs::path& dir : folders) {
        if (!fs::is_directory(dir)) continue;
        if (fs::exists(dir / (name + ".json"))) return read_json(dir / (name + ".json"));
        for (const auto& file : fs::directory_iterator(dir))
            if (file.path().extension() == ".json") known.push_back(file.path().stem().string());
    }
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    const std::string near = nearest(name, known);
    throw Error(Fault::input, place, "there are no equations named \"" + name + "\"",
                near.empty() ? "Known: " + join(known) + "; or write the assembly here" : "Did you mean \"" + near + "\"?");
}

}    // namespace

int Equations::find(const std::string& name) const {
    for (std::size_t i = 0; i < variables.size(); ++i)
        if (variables[i].name == name) return int(i);
    return -1;
}

bool Equations::dissipate() const {
    return std::ranges::any_of(variables, [](const Variable& v) {
        return std::ranges::any_of(v.terms, [](const Term& term) { return term.dissipation != nullptr; });
    });
}

namespace {

/// What reads c0 and rho0 of one medium only.
void refuse_several_media(const Case& scene, const Section& root) {
    if (!scene.media->several()) return;
    const auto refuse = [&](const std::string& what, const std::string& remedy) {
        throw Error(Fault::input, root.file() + ": /medium", "there are several media, and " + what + " one only", remedy);
    };
    if (!scene.method->meshfree()) {
        if (!scene.method->several_media()) refuse("method " + scene.method_name + " knows of", "Use another method");
        return;
    }
    if (scene.motion == Motion::lagrangian || scene.neighbours == Neighbours::moving)
        refuse("sets that find their neighbours anew know of", "Use a frozen set");
    for (const Variable& v : scene.equations.variables) {
        if (!v.evolved()) refuse("the state of \"" + v.name + "\" knows of", "Evolve p itself, as equations \"acoustics\" do");
        if (v.name == "rho") refuse("the density \"rho\" begins with that of", "Use rho0, which each medium has of its own");
        for (const Term& term : v.terms)
            if (term.viscosity) refuse("viscosity knows of", "Leave the viscosity out");
    }
}

}    // namespace

void read_equations(Case& scene, Section& root, Registry& registry) {
    if (!scene.method->meshfree() && !root.has("equations") && !root.has("viscosity") && !root.has("dissipation")) {
        scene.equations.variables.push_back({.name = "p"});    // what every method of sound knows
        scene.equations.variables.push_back({.name = "u", .is_vector = true});
        return refuse_several_media(scene, root);
    }
    const Json& given = root.need("equations", "Name a preset such as \"linear_acoustics\", or write the assembly");
    const Json* assembly = &given;
    if (given.is_string()) {
        auto preset = std::make_shared<Json>(load_preset(given.get<std::string>(), scene, root.place("equations")));
        scene.presets.push_back(preset);
        assembly = preset.get();
    }
    Section section(*assembly, root.file(), "/equations");
    read_assembly(scene, section, registry);
    root.resolved["equations"] = section.resolved;
    Equations& e = scene.equations;
    e.velocity = e.find(scene.velocity_name);
    const bool matters = scene.motion == Motion::lagrangian || scene.velocity_name != common_key("arrangement", "velocity").initial.text;
    if (matters && (e.velocity < 0 || !e.variables[std::size_t(e.velocity)].is_vector))
        throw Error(Fault::input, root.file() + ": /particles/velocity", "\"" + scene.velocity_name + "\" is no vector of the equations",
                    std::string("Name the variable that moves the particles, or ") +
                        (scene.motion == Motion::lagrangian ? "set \"motion\": \"frozen\"" : "leave it out"));
    if (scene.method->meshfree() && (e.find("p") < 0 || e.find("u") < 0))
        root.fail("equations", "there is no pressure p or no velocity u", "Sound needs both: sources, references and results refer to them");
    if (root.has("viscosity")) root.resolved["viscosity"] = append_viscosity(scene, root.child("viscosity", ""), registry);
    if (root.has("dissipation")) root.resolved["dissipation"] = append_dissipation(scene, root.child("dissipation", ""), registry);
    check_dissipation(scene, root);
    refuse_several_media(scene, root);
}

}    // namespace sphonic
