#include <algorithm>

#include <sphonic/error.hpp>
#include <sphonic/parameters.hpp>

#include "case_reader.hpp"

namespace sphonic {
namespace {

KernelUse read_kernel_use(Case& scene, Section& section, Registry& registry, const std::string& name) {
    KernelUse use{.name = name, .kernel = read_plugin<abi::Kernel>(scene, section, registry)};
    if (!use.kernel->defined(scene.box.dimension))
        section.fail("type", "this kernel is not defined in dimension " + std::to_string(scene.box.dimension), "Choose another kernel");
    obey_key_rules(section, "kernel", scene);
    const auto h = section.optional_real(common_key("kernel", "h"));
    const auto ratio = section.optional_real(common_key("kernel", "h_over_dx"));
    use.h = h ? *h : *ratio * scene.box.dx;
    section.finish();
    const std::string support = "the support of " + number_text(use.radius()) + " m ";
    double longest = 0;
    for (int a = 0; a < scene.box.dimension; ++a) longest = std::max(longest, scene.box.upper[a] - scene.box.lower[a]);
    if (use.radius() < scene.box.dx)
        section.fail(h ? "h" : "h_over_dx", support + "reaches no neighbour", "Choose h so that support * h > dx");
    if (use.radius() > longest)
        section.fail(h ? "h" : "h_over_dx", support + "is wider than the box", "Choose a smaller h or a larger box");
    return use;
}

void require_inside(const abi::Box& box, const std::vector<double>& point, const Section& section, const std::string& key) {
    for (int a = 0; a < box.dimension; ++a) {
        const double x = point[std::size_t(a)], margin = 1e-9 * box.dx;
        if (x >= box.lower[a] - margin && x <= box.upper[a] + margin) continue;
        section.fail(key, Json(point).dump() + " lies outside the box", "Choose a point with " + number_text(box.lower[a]) +
                     " <= " + "xyz"[a] + " <= " + number_text(box.upper[a]));
    }
}

double courant_length(Case& scene, Section& section) {
    const std::string name = section.read(common_key("integrator", "courant_length")).text;
    if (name == "dx") return scene.box.dx;
    if (scene.kernels.empty()) section.fail("courant_length", "there is no kernel to take h from", "Use \"dx\"");
    return scene.kernels[0].h;
}

}    // namespace

void read_kernels(Case& scene, Section& root, Registry& registry) {
    if (root.has("kernel")) {
        Section section = root.child("kernel", "");
        scene.kernels.push_back(read_kernel_use(scene, section, registry, ""));
        root.resolved["kernel"] = section.resolved;
    }
    if (root.has("kernels")) {
        Section section = root.child("kernels", "");
        for (const auto& [name, value] : section.value().items()) {
            if (name.empty()) section.fail("", "\"\" is no name of a kernel", "Give it one that terms can refer to");
            Section inner = section.child(name, "");
            scene.kernels.push_back(read_kernel_use(scene, inner, registry, name));
            section.resolved[name] = inner.resolved;
        }
        root.resolved["kernels"] = section.resolved;
    }
    if (scene.kernels.empty() && scene.method->meshfree())
        root.fail("kernel", "is missing", "Give { \"type\": " + join(registry.names("kernel")) + ", \"h_over_dx\": 1.3 }");
}

void read_reference(Case& scene, Section& root, Registry& registry) {
    if (!root.has("reference")) return;
    Section section = root.child("reference", "");
    ReferenceUse use{.reference = read_plugin<abi::Reference>(scene, section, registry)};
    if (section.has("region"))
        use.region.emplace(section.text("region", ""), constants(scene), scene.box.dimension, section.place("region"));
    use.scale = section.optional_real(common_key("reference", "scale"));
    section.finish();
    scene.reference = std::move(use);
    root.resolved["reference"] = section.resolved;
}

void prepare_reference(Case& scene, const Section& root) {
    if (!scene.reference) return;
    std::vector<abi::PlaneWave> waves;
    for (const SourceUse& source : scene.sources)
        if (const abi::PlaneWave* wave = source.source->wave()) waves.push_back(*wave);
    prepared(root.place("reference"),
             [&] { scene.reference->reference->prepare({scene.box.dimension, scene.medium, scene.media->view(), waves.data(), int(waves.size())}); });
    if (scene.media->several() && !scene.reference->reference->several_media())
        scene.warnings.push_back(root.place("reference") + ": it knows of one medium, the first of the list");
}

void read_sources(Case& scene, Section& root, Registry& registry) {
    const Json* list = root.find("sources");
    if (!list) return;
    if (!list->is_array()) root.fail("sources", shown(*list) + " is not a list", "Write [ { \"type\": ... } ]");
    Json resolved = Json::array();
    for (std::size_t i = 0; i < list->size(); ++i) {
        Section section((*list)[i], root.file(), "/sources/" + std::to_string(i));
        SourceUse use{.source = read_plugin<abi::Source>(scene, section, registry), .region = {}, .place = section.place()};
        prepared(use.place, [&] {
            use.source->prepare({scene.box.dimension, scene.medium, scene.media->view(), scene.box, scene.reference ? scene.reference->reference.get() : nullptr});
        });
        obey_key_rules(section, "source", scene, use.source->action().sets());
        if (section.has("region"))
            use.region.emplace(section.text("region", ""), constants(scene), scene.box.dimension, section.place("region"));
        section.finish();
        scene.sources.push_back(std::move(use));
        resolved.push_back(section.resolved);
    }
    root.resolved["sources"] = resolved;
}

void read_initial(Case& scene, Section& root) {
    if (!root.has("initial")) return;
    Section section = root.child("initial", "");
    const int d = scene.box.dimension;
    for (const Variable& variable : scene.equations.variables) {
        const Json* given = section.find(variable.name);
        if (!given) continue;
        InitialField field{.variable = variable.name};
        const bool fits = variable.is_vector ? given->is_array() && int(given->size()) == d : given->is_string();
        if (!fits)
            section.fail(variable.name, shown(*given) + " does not fit this variable",
                         variable.is_vector ? "Give a list of " + std::to_string(d) + " expressions" : "Give an expression");
        for (int c = 0; c < variable.components(d); ++c) {
            const Json& text = variable.is_vector ? (*given)[std::size_t(c)] : *given;
            if (!text.is_string()) section.fail(variable.name, shown(text) + " is not an expression", "Give expressions as strings");
            field.components.emplace_back(text.get<std::string>(), constants(scene), d, section.place(variable.name));
        }
        scene.initial.push_back(std::move(field));
        section.resolved[variable.name] = *given;
    }
    section.finish();
    root.resolved["initial"] = section.resolved;
}

void read_time(Case& scene, Section& root, Registry& registry) {
    Section section = root.child("integrator", "Give { \"type\": " + join(registry.names("integrator")) + " }");
    scene.integrator = read_plugin<abi::Integrator>(scene, section, registry);
    scene.integrator_name = section.resolved["type"];
    obey_key_rules(section, "integrator", scene);
    StepChoice& step = scene.step;
    step.dt = section.optional_real(common_key("integrator", "dt"));
    step.courant = section.optional_real(common_key("integrator", "courant"));
    step.courant_length = courant_length(scene, section);
    if (!step.dt && !step.courant) step.safety = section.real(common_key("integrator", "safety"));
    step.allow_unstable = std::string(section.read(common_key("integrator", "unstable")).text) == "allow";
    section.finish();
    root.resolved["integrator"] = section.resolved;
    scene.until = root.real(common_key("case", "until"));
    scene.active = std::string(root.read(common_key("case", "active")).text) == "all" ? Active::all : Active::automatic;
    scene.precision = std::string(root.read(common_key("case", "precision")).text) == "single" ? Precision::single : Precision::usual;
    if (scene.precision == Precision::single && !scene.method->meshfree())
        root.fail("precision", "method " + scene.method_name + " works in double precision", "Choose \"double\"");
}

void read_output(Case& scene, Section& root) {
    static const Json none = Json::object();
    const Json* given = root.find("output");
    Section section(given ? *given : none, root.file(), "/output");
    const double every = section.real(common_key("output", "every"));
    scene.output.every = std::min(every, scene.until);
    if (const Json* probes = section.find("probes")) {
        if (!probes->is_array()) section.fail("probes", shown(*probes) + " is not a list", "Write [[x, y], ...]");
        for (std::size_t i = 0; i < probes->size(); ++i) {
            const Json wrapped{{std::to_string(i), (*probes)[i]}};
            Section list(wrapped, root.file(), "/output/probes");
            scene.output.probes.push_back(list.point(std::to_string(i), scene.box.dimension));
            require_inside(scene.box, scene.output.probes.back(), list, std::to_string(i));
        }
        section.resolved["probes"] = *probes;
    }
    scene.output.fields = section.read(common_key("output", "fields")).boolean;
    if (!scene.output.fields && scene.output.probes.empty() && !scene.reference)
        section.fail("fields", "false leaves nothing to ask for", "Give probes or a reference, or leave it out");
    section.finish();
    root.resolved["output"] = section.resolved;
}

}    // namespace sphonic
