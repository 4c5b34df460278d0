#include <sphonic/equations.hpp>

#include <algorithm>

#include <sphonic/error.hpp>
#include <sphonic/nearest.hpp>

#include "case_reader.hpp"
#include "times.hpp"

#ifndef SPHONIC_EQUATIONS_DIR
#error "SPHONIC_EQUATIONS_DIR names the folder of equation presets"
#endif

namespace fs = std::filesystem;

namespace sphonic {
namespace {

const std::vector<std::string> operator_keys{"divergence", "gradient", "viscosity"};

/// Reads one case's equations; the first pass names the variables, the second fills in what refers to them.
class EquationReader {
public:
    EquationReader(Case& scene, Registry& registry) : scene_(scene), registry_(registry) {}

    void read(Section& section) {
        for (const auto& [name, value] : section.value().items())
            if (name != "order") out().variables.push_back({.name = name, .is_vector = name == "u" || name == "U"});
        if (out().variables.empty()) section.fail("", "there are no equations", "Give at least one variable");
        for (Variable& variable : out().variables) {
            const Json& value = section.need(variable.name, "");
            const std::string at = section.pointer() + "/" + variable.name;
            if (value.is_array())
                section.resolved[variable.name] = read_rates(variable, value, section.file(), at);
            else
                section.resolved[variable.name] = read_algebraic(variable, Section(value, section.file(), at));
        }
        refuse_cycles(section);
        out().density = out().find("rho");
        read_order(section);
        section.finish();
    }

    Json append_viscosity(Section section, const std::string& key) {
        const int u = out().find("u");
        if (u < 0) section.fail("", "the equations have no velocity u to act on", "Remove the viscosity or name u in the equations");
        for (const Term& term : out().variables[u].terms)
            if (term.viscosity) section.fail("", "viscosity is given here and in /equations", "Remove one of the two");
        Term term{.op = Term::Operator::viscosity, .operand = u};
        term.viscosity = read_plugin<abi::Viscosity>(scene_, section, registry_, key);
        section.finish();
        out().variables[u].terms.push_back(std::move(term));
        return section.resolved;
    }

private:
    Case& scene_;
    Registry& registry_;
    Equations& out() { return scene_.equations; }

    int variable(Section& section, const std::string& key) {
        const std::string name = section.text(key, "");
        const int found = out().find(name);
        if (found >= 0) return found;
        std::vector<std::string> names;
        for (const Variable& v : out().variables) names.push_back(v.name);
        section.fail(key, "there is no variable \"" + name + "\"", "The equations have " + join(names));
    }

    Json read_algebraic(Variable& variable_, Section section) {
        const bool known = section.has("state");
        if (!known) section.fail("", "an algebraic variable needs the key \"state\"", "Write {\"state\": NAME, \"of\": VARIABLE}, or a list of rate terms");
        variable_.of = variable(section, "of");
        if (out().variables[variable_.of].is_vector || variable_.is_vector)
            section.fail("of", "a state relates two scalar variables", "Name a scalar variable");
        variable_.state = read_plugin<abi::State>(scene_, section, registry_, "state");
        section.finish();
        return section.resolved;
    }

    /// Each algebraic variable must come, over others, from an evolved one.
    void refuse_cycles(const Section& section) {
        const auto& variables = out().variables;
        for (const Variable& variable : variables) {
            const Variable* at = &variable;
            for (std::size_t steps = 0; !at->evolved(); at = &variables[std::size_t(at->of)])
                if (++steps > variables.size())
                    throw Error(Fault::input, section.place(variable.name) + "/of", "\"" + variable.name + "\" comes from itself and from no evolved variable",
                                 "Let the chain end in a variable with rate terms");
        }
    }

    Json read_rates(Variable& target, const Json& list, const std::string& file, const std::string& pointer) {
        Json resolved = Json::array();
        if (list.empty())
            throw Error(Fault::input, file + ": " + pointer, "there is no rate term", "Give at least one, or remove the variable");
        for (std::size_t i = 0; i < list.size(); ++i) {
            Section section(list[i], file, pointer + "/" + std::to_string(i));
            target.terms.push_back(read_term(target, section));
            section.finish();
            resolved.push_back(section.resolved);
        }
        return resolved;
    }

    Term read_term(const Variable& target, Section& section) {
        std::vector<std::string> present;
        for (const auto& key : operator_keys)
            if (section.has(key)) present.push_back(key);
        if (present.size() != 1)
            section.fail("", present.empty() ? "the term has no operator" : "the term has several operators: " + join(present),
                         "Give exactly one of " + join(operator_keys));
        if (present[0] == "viscosity") return read_viscosity(target, section);

        Term term{.op = present[0] == "gradient" ? Term::Operator::gradient : Term::Operator::divergence};
        term.operand = variable(section, present[0]);
        const bool gradient = term.op == Term::Operator::gradient;
        if (out().variables[term.operand].is_vector == gradient || target.is_vector != gradient)
            section.fail(present[0], gradient ? "a gradient takes a scalar and gives a vector" : "a divergence takes a vector and gives a scalar",
                         "Vectors are u and U");
        term.form = read_form(section);
        term.kernel = read_kernel(section);
        read_times(term, scene_, section);
        return term;
    }

    Term read_viscosity(const Variable& target, Section& section) {
        if (!target.is_vector) section.fail("viscosity", "viscosity acts on a velocity", "Put the term under u");
        Term term{.op = Term::Operator::viscosity, .operand = out().find(target.name)};
        term.kernel = read_kernel(section);
        term.viscosity = read_plugin<abi::Viscosity>(scene_, section, registry_, "viscosity");
        return term;
    }

    /// "difference", or {"type": "difference", parameters...}.
    std::unique_ptr<abi::Form> read_form(Section& section) {
        const Json& form = section.need("form", "Name a form: " + join(registry_.names("form")));
        if (form.is_object()) {
            Section inner = section.child("form", "");
            auto made = read_plugin<abi::Form>(scene_, inner, registry_);
            inner.finish();
            section.resolved["form"] = inner.resolved;
            return made;
        }
        const std::string name = section.text("form", "");
        return default_plugin<abi::Form>(scene_, registry_, name, section.place("form"));
    }

    int read_kernel(Section& section) {
        if (!section.has("kernel")) return 0;
        const std::string name = section.text("kernel", "");
        for (std::size_t i = 0; i < scene_.kernels.size(); ++i)
            if (scene_.kernels[i].name == name) return int(i);
        section.fail("kernel", "there is no kernel \"" + name + "\" in /kernels", "Name one of /kernels");
    }

    void read_order(Section& section) {
        Equations& e = out();
        if (const Json* order = section.find("order")) {
            read_given_order(*order, section);
            section.resolved["order"] = *order;
            return;
        }
        std::vector<int> vectors, scalars;
        for (std::size_t i = 0; i < e.variables.size(); ++i)
            if (e.variables[i].evolved()) (e.variables[i].is_vector ? vectors : scalars).push_back(int(i));
        if (!vectors.empty()) e.order.push_back(vectors);
        if (!scalars.empty() || e.order.empty()) e.order.push_back(scalars);
        e.positions_group = int(e.order.size()) - 1;
    }

    void read_given_order(const Json& order, Section& section) {
        Equations& e = out();
        const std::string remedy = "Write lists of evolved variables, each once, such as [[\"u\"], [\"p\", \"x\"]]";
        std::vector<int> seen(e.variables.size(), 0);
        if (!order.is_array()) section.fail("order", shown(order) + " is not a list", remedy);
        for (const Json& group : order) {
            if (!group.is_array()) section.fail("order", shown(group) + " is not a list", remedy);
            e.order.emplace_back();
            for (const Json& name : group) {
                const std::string text = name.is_string() ? name.get<std::string>() : "";
                if (text == "x") {
                    e.positions_group = int(e.order.size()) - 1;
                    continue;
                }
                const int index = e.find(text);
                if (index < 0 || !e.variables[index].evolved() || seen[index]++)
                    section.fail("order", shown(name) + " is not an evolved variable, or stands twice", remedy);
                e.order.back().push_back(index);
            }
        }
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (e.variables[i].evolved() && !seen[i]) section.fail("order", "\"" + e.variables[i].name + "\" is in no group", remedy);
        if (e.positions_group < 0) e.positions_group = int(e.order.size()) - 1;
    }
};

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

void read_equations(Case& scene, Section& root, Registry& registry) {
    if (!scene.method->meshfree() && !root.has("equations") && !root.has("viscosity")) {
        scene.equations.variables.push_back({.name = "p"});    // what every method of sound knows
        scene.equations.variables.push_back({.name = "u", .is_vector = true});
        return;
    }
    const Json& given = root.need("equations", "Name a preset such as \"linear_acoustics\", or write the assembly");
    const Json* assembly = &given;
    if (given.is_string()) {
        auto preset = std::make_shared<Json>(load_preset(given.get<std::string>(), scene, root.place("equations")));
        scene.presets.push_back(preset);
        assembly = preset.get();
    }
    EquationReader reader(scene, registry);
    Section section(*assembly, root.file(), "/equations");
    reader.read(section);
    root.resolved["equations"] = section.resolved;
    Equations& e = scene.equations;
    e.velocity = e.find(scene.velocity_name);
    if (scene.motion == Motion::lagrangian && (e.velocity < 0 || !e.variables[std::size_t(e.velocity)].is_vector))
        throw Error(Fault::input, root.file() + ": /particles/velocity", "\"" + scene.velocity_name + "\" is no vector of the equations",
                    "Name the variable that moves the particles, or set \"motion\": \"frozen\"");
    if (scene.method->meshfree() && (e.find("p") < 0 || e.find("u") < 0))
        root.fail("equations", "there is no pressure p or no velocity u", "Sound needs both: sources, references and results refer to them");
    if (root.has("viscosity")) root.resolved["viscosity"] = reader.append_viscosity(root.child("viscosity", ""), "type");
}

}    // namespace sphonic
