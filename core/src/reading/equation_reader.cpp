#include "equation_reader.hpp"

#include <algorithm>
#include <cctype>

#include <sphonic/error.hpp>
#include <sphonic/parameters.hpp>

#include "times.hpp"

namespace sphonic {
namespace {

const std::vector<std::string> operator_keys{"divergence", "gradient", "viscosity", "dissipation"};

class EquationReader {
public:
    EquationReader(Case& scene, Registry& registry) : scene_(scene), registry_(registry) {}

    void read(Section& section) {
        for (const auto& [name, value] : section.value().items()) {
            if (name == "order") continue;
            require_name(name, section);
            out().variables.push_back({.name = name, .is_vector = name == "u" || name == "U"});
        }
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
        read_order(out(), section);
        section.finish();
    }

    Json append_viscosity(Section section) {
        const int u = out().find("u");
        if (u < 0) section.fail("", "the equations have no velocity u to act on", "Remove the viscosity or name u in the equations");
        for (const Term& term : out().variables[u].terms)
            if (term.viscosity) section.fail("", "viscosity is given here and in /equations", "Remove one of the two");
        Term term{.op = Term::Operator::viscosity, .operand = u};
        term.viscosity = read_plugin<abi::Viscosity>(scene_, section, registry_);
        section.finish();
        out().variables[u].terms.push_back(std::move(term));
        return section.resolved;
    }

private:
    Case& scene_;
    Registry& registry_;
    Equations& out() { return scene_.equations; }

    static void require_name(const std::string& name, const Section& section) {
        const auto word = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
        const bool is_word = !name.empty() && std::ranges::all_of(name, word) && !std::isdigit(static_cast<unsigned char>(name[0]));
        if (!is_word) section.fail(name, "\"" + name + "\" is no name of a variable", "Use letters, digits and _, a letter first");
        if (std::ranges::count(reserved_names(), name))
            section.fail(name, "\"" + name + "\" means something else in expressions", "Choose another name than " + join(reserved_names()));
    }

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
        if (present[0] == "dissipation") return read_dissipation(scene_, section, registry_, "dissipation", out().find(target.name), read_kernel(section));

        Term term{.op = present[0] == "gradient" ? Term::Operator::gradient : Term::Operator::divergence};
        term.operand = variable(section, present[0]);
        const bool gradient = term.op == Term::Operator::gradient;
        if (out().variables[term.operand].is_vector == gradient || target.is_vector != gradient)
            section.fail(present[0], gradient ? "a gradient takes a scalar and gives a vector" : "a divergence takes a vector and gives a scalar",
                         "Vectors are u and U");
        term.form = read_form(section);
        term.form_text = section.resolved["form"].dump();
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

    /// "difference", or {"type": "difference", parameters...}. If not given, one that converges, and bears contrasts of media.
    std::unique_ptr<abi::Form> read_form(Section& section) {
        const std::string usual = scene_.media->several() ? "impedance" : "corrected";
        if (const Json* form = section.find("form"); form && form->is_object()) {
            Section inner = section.child("form", "");
            auto made = read_plugin<abi::Form>(scene_, inner, registry_);
            inner.finish();
            section.resolved["form"] = inner.resolved;
            return made;
        }
        const std::string name = section.text("form", usual);
        return default_plugin<abi::Form>(scene_, registry_, name, section.place("form"));
    }

    int read_kernel(Section& section) {
        if (!section.has("kernel")) return 0;
        const std::string name = section.text("kernel", "");
        for (std::size_t i = 0; i < scene_.kernels.size(); ++i)
            if (!name.empty() && scene_.kernels[i].name == name) return int(i);
        section.fail("kernel", "there is no kernel \"" + name + "\" in /kernels", "Name one of /kernels");
    }
};

}    // namespace

void read_assembly(Case& scene, Section& section, Registry& registry) { EquationReader(scene, registry).read(section); }

Json append_viscosity(Case& scene, Section section, Registry& registry) {
    return EquationReader(scene, registry).append_viscosity(std::move(section));
}

}    // namespace sphonic
