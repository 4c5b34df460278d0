#include <sphonic/case.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <sphonic/error.hpp>
#include <sphonic/version.hpp>

#include "case_reader.hpp"

namespace fs = std::filesystem;

namespace sphonic {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double positive = std::numeric_limits<double>::min();

void read_medium(Case& scene, Section& root) {
    Section medium = root.child("medium", "Give { \"c0\": sound speed [m/s], \"rho0\": density [kg/m^3] }");
    scene.medium.c0 = medium.real(real_row("c0", "m/s", positive, infinite, "sound speed"));
    scene.medium.rho0 = medium.real(real_row("rho0", "kg/m^3", positive, infinite, "density at rest"));
    medium.finish();
    root.resolved["medium"] = medium.resolved;
}

void read_dimension(Case& scene, Section& root) {
    const Json& d = root.need("dimension", "Give 1, 2 or 3");
    if (!d.is_number_integer() || d.get<double>() < 1 || d.get<double>() > 3)
        root.fail("dimension", shown(d) + " is not a dimension", "Give 1, 2 or 3");
    scene.box.dimension = d.get<int>();
    root.resolved["dimension"] = d;
}

void read_method(Case& scene, Section& root, Registry& registry) {
    if (!root.has("method")) {
        scene.method_name = "particles";
        scene.method = default_plugin<abi::Method>(scene, registry, "particles", root.place("method"));
        root.resolved["method"] = {{"type", "particles"}};
        return;
    }
    Section section = root.child("method", "");
    scene.method = read_plugin<abi::Method>(scene, section, registry);
    scene.method_name = section.resolved["type"];
    section.finish();
    root.resolved["method"] = section.resolved;
}

/// A method without particles passes over what only particles need; it says so.
void warn_unused(Case& scene, Section& root) {
    if (scene.method->meshfree()) return;
    std::vector<std::string> unused;
    for (const char* key : {"kernel", "kernels", "equations", "viscosity"})
        if (root.has(key)) unused.push_back(key);
    unused.push_back("integrator type");
    scene.warnings.push_back("method " + scene.method_name + " does not use " + join(unused));
}

void check_provenance(Case& scene, Section& root) {
    const Json* carried = root.find("provenance");
    if (!carried || !carried->is_object() || !carried->contains("abi")) return;
    if ((*carried)["abi"] != abi_tag())
        scene.warnings.push_back("this case was resolved with ABI " + shown((*carried)["abi"]) + ", this is " + abi_tag() +
                                 ": results may differ in the last digits");
}

}    // namespace

void note_provenance(Case& scene, const Plugin& plugin) {
    (*scene.provenance)["plugins"][plugin.kind + "." + plugin.name] = plugin.file.string();
}

double Case::radius() const {
    double largest = 0;
    for (const KernelUse& use : kernels) largest = std::max(largest, use.radius());
    return largest;
}

void SourceUse::inside(const abi::Points& points, unsigned char* out) const {
    source->reach(points, out);
    double x[3] = {0, 0, 0};
    for (int i = 0; region && i < points.n; ++i) {
        for (int a = 0; a < points.dimension; ++a) x[a] = points.x[a][i];
        out[i] = out[i] && region->contains(x);
    }
}

void SourceUse::reaches_nothing() const {
    if (region) throw Error(Fault::input, place + "/region", "no particle lies in \"" + region->text() + "\"", "Choose a region inside the box");
    throw Error(Fault::input, place, "it reaches no particle", "Put it inside the box");
}

Case::Behind Case::behind(int v) const {
    double slope = 1;
    while (v >= 0 && !equations.variables[std::size_t(v)].evolved()) {
        const Variable& variable = equations.variables[std::size_t(v)];
        slope *= variable.state->derivative(medium, 0);
        v = variable.of;
    }
    return {v, slope};
}

bool Case::initial_values(const std::string& variable, int component, const abi::Points& points, double* out) const {
    for (const InitialField& field : initial) {
        if (field.variable != variable) continue;
        double x[3] = {0, 0, 0};
        for (int i = 0; i < points.n; ++i) {
            for (int a = 0; a < points.dimension; ++a) x[a] = points.x[a][i];
            out[i] = field.components[std::size_t(component)](x);
            if (!std::isfinite(out[i]))
                throw Error(Fault::input, file + ": /initial/" + variable, "\"" + field.components[std::size_t(component)].text() +
                            "\" is not finite at x = " + std::to_string(x[0]), "Choose an expression that is finite in the whole box");
        }
        return true;
    }
    return false;
}

Expression::Constants constants(const Case& scene) {
    const auto& m = scene.medium;
    Expression::Constants known{{{"c0", m.c0}, {"rho0", m.rho0}, {"K", m.rho0 * m.c0 * m.c0}, {"dx", scene.box.dx}}};
    if (!scene.kernels.empty()) known.values.emplace_back("h", scene.kernels[0].h);
    return known;
}

Case load_case(Json document, const fs::path& file, Registry& registry) {
    Case scene;
    scene.provenance = std::make_shared<Json>(Json::object());
    scene.file = file.string();
    auto kept = std::make_shared<const Json>(std::move(document));
    scene.source_text = kept;
    Section root(*kept, scene.file, "");
    scene.title = root.text("title", file.stem().string());
    read_dimension(scene, root);
    read_medium(scene, root);
    read_method(scene, root, registry);
    read_space(scene, root, registry);
    read_kernels(scene, root, registry);
    read_equations(scene, root, registry);
    read_reference(scene, root, registry);
    read_sources(scene, root, registry);
    prepare_reference(scene, root);
    read_initial(scene, root);
    read_time(scene, root, registry);
    read_output(scene, root);
    check_provenance(scene, root);
    root.finish();
    warn_unused(scene, root);
    (*scene.provenance)["version"] = version();
    (*scene.provenance)["commit"] = commit();
    (*scene.provenance)["abi"] = abi_tag();
    scene.resolved = std::make_shared<Json>(root.resolved);
    (*scene.resolved)["provenance"] = *scene.provenance;
    return scene;
}

Case load_case(const fs::path& file, const std::vector<std::string>& overrides, Registry& registry) {
    Json document = read_json(file);
    for (const std::string& assignment : overrides) set_at(document, assignment);
    return load_case(std::move(document), file, registry);
}

}    // namespace sphonic
