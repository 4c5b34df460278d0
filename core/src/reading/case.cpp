#include <sphonic/case.hpp>

#include <algorithm>
#include <cmath>

#include <sphonic/error.hpp>
#include <sphonic/parameters.hpp>
#include <sphonic/version.hpp>

#include "case_reader.hpp"
#include "form_fit.hpp"
#include "stretched_parts.hpp"

namespace fs = std::filesystem;

namespace sphonic {
namespace {

void read_dimension(Case& scene, Section& root) {
    const Json& d = root.need("dimension", "Give 1, 2 or 3");
    const auto whole = whole_number(d);
    if (!whole || *whole < 1 || *whole > 3) root.fail("dimension", shown(d) + " is not a dimension", "Give 1, 2 or 3");
    root.resolved["dimension"] = scene.box.dimension = int(*whole);
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
    for (const char* key : {"kernel", "kernels", "equations", "viscosity", "dissipation"})
        if (root.has(key)) unused.push_back(key);
    if (!scene.arrangement->regular()) unused.push_back("particles type: it runs on its own grid of this spacing");
    if (scene.integrator_name != "leapfrog") unused.push_back("integrator type: it steps by a leapfrog of its own");
    if (!unused.empty()) scene.warnings.push_back("method " + scene.method_name + " does not use " + join(unused));
}

/// `rest` of a place of `planned_places`, below a value that stands at `pointer`.
void refuse_auto(const Section& root, const Json& value, const std::string& pointer, const std::string& rest) {
    if (rest.empty()) {
        if (value == "auto") throw Error(Fault::input, root.file() + ": " + pointer, "\"auto\" is still to be planned", "Give the case an \"accuracy\", such as { \"target\": 0.01 }, or use plan and then the case that it writes");
        return;
    }
    const std::size_t end = std::min(rest.find('/', 1), rest.size());
    const std::string key = rest.substr(1, end - 1), after = rest.substr(end);
    if (key == "*" && value.is_array())
        for (std::size_t i = 0; i < value.size(); ++i) refuse_auto(root, value[i], pointer + "/" + std::to_string(i), after);
    else if (value.is_object() && value.contains(key))
        refuse_auto(root, value[key], pointer + "/" + key, after);
}

void refuse_unplanned(Section& root) {
    if (root.has("accuracy")) root.fail("accuracy", "this case is still to be planned", "Use check, run, or plan and then the case that it writes");
    for (const std::string& place : planned_places()) refuse_auto(root, root.value(), "", place);
}

void read_title(Case& scene, Section& root) {
    scene.title = root.text("title", fs::path(scene.file).stem().string());
    if (scene.title.empty()) root.fail("title", "the text is empty", "Give a title, or leave it out: it is then the file's name");
}

void check_provenance(Case& scene, Section& root) {
    const Json* carried = root.find("provenance");
    if (carried && !carried->is_object()) root.fail("provenance", shown(*carried) + " is not an object", "Leave it out");
    if (!carried || !carried->contains("abi")) return;
    if ((*carried)["abi"] != abi_tag())
        scene.warnings.push_back("this case was resolved with ABI " + shown((*carried)["abi"]) + ", this is " + abi_tag() +
                                 ": results may differ in the last digits");
}

}    // namespace

void note_provenance(Case& scene, const Plugin& plugin) {
    (*scene.provenance)["plugins"][plugin.kind + "." + plugin.name] = plugin.file.string();
}

void obey_key_rules(Section& section, const std::string& kind, const Case& scene, bool imposes) {
    for (const KeyRule& rule : key_rules(kind))
        if (rule.how != KeyRule::How::required_to_impose || imposes) section.obey(rule, kind, scene.box.dimension);
}

void require_fitting_vectors(const Section& section, const Plugin& plugin, int dimension) {
    for (const abi::ParameterInfo& row : plugin.parameters) {
        if (row.initial.type != abi::ParameterType::vector || !section.value().contains(row.name)) continue;
        const Json& list = section.value()[row.name];
        if (int(list.size()) != dimension)
            section.fail(row.name, shown(list) + " does not fit dimension " + std::to_string(dimension), list_remedy(dimension));
    }
}

double Case::radius() const {
    double largest = 0;
    for (const KernelUse& use : kernels) largest = std::max(largest, use.radius());
    for (const Variable& v : equations.variables)
        for (const Term& term : v.terms)
            if (term.form) largest = std::max(largest, (on_lattice() ? term.form->reach() : term.form->cloud_reach(box.dimension)) * box.dx);
    return largest;
}

double Case::steps_of(double dt) const { return std::max(1.0, std::ceil(until / dt - 1e-9)); }

void SourceUse::inside(const abi::Points& points, unsigned char* out) const {
    source->reach(points, out);
    double x[3] = {0, 0, 0};
    for (int i = 0; region && i < points.n; ++i) {
        for (int a = 0; a < points.dimension; ++a) x[a] = points.x[a][i];
        out[i] = out[i] && region->contains(x);
    }
}

void SourceUse::reaches_nothing() const {
    if (region && !source->action().sets())
        throw Error(Fault::input, place + "/region", "no particle that the source reaches lies in \"" + region->text() + "\"", "Choose a region around the source");
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

Expression::Constants constants(const Case& scene, const abi::Medium& m) {
    Expression::Constants known{{{"c0", m.c0}, {"rho0", m.rho0}, {"K", m.rho0 * m.c0 * m.c0}, {"dx", scene.box.dx}}, scene.stretch};
    if (!scene.kernels.empty()) known.values.emplace_back("h", scene.kernels[0].h);
    return known;
}

Expression::Constants constants(const Case& scene) { return constants(scene, scene.medium); }

Case load_case(Json document, const fs::path& file, Registry& registry) {
    Case scene;
    scene.provenance = std::make_shared<Json>(Json::object());
    scene.file = file.string();
    scene.registry = &registry;
    auto kept = std::make_shared<const Json>(std::move(document));
    scene.source_text = kept;
    Section root(*kept, scene.file, "");
    root.pass_over_schema();
    refuse_unplanned(root);
    read_title(scene, root);
    read_dimension(scene, root);
    read_method(scene, root, registry);
    read_space(scene, root, registry);
    read_media(scene, root);
    lay_out(scene, root);
    read_kernels(scene, root, registry);
    read_equations(scene, root, registry);
    read_obstacles(scene, root, registry);
    read_reference(scene, root, registry);
    read_sources(scene, root, registry);
    prepare_reference(scene, root);
    read_initial(scene, root);
    read_time(scene, root, registry);
    read_output(scene, root);
    check_provenance(scene, root);
    if (scene.stretch) enter(scene);
    fit_forms(scene);
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
