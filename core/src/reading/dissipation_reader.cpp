#include <sphonic/parameters.hpp>

#include "disorder.hpp"
#include "equation_reader.hpp"

namespace sphonic {
namespace {

double usual_strength(Case& scene, const Term& term, const Section& section) {
    const auto found = disorder(scene, scene.kernels[std::size_t(term.kernel)]);
    if (!found) section.fail("alpha", "is missing, and the set is too small to work it out", "Give the strength, such as 0.2");
    if (*found == 0) scene.warnings.push_back(section.pointer() + ": the set is regular and needs no dissipation: alpha is " + number_text(term.dissipation->strength(0)));
    return term.dissipation->strength(*found);
}

}    // namespace

Term read_dissipation(Case& scene, Section& section, Registry& registry, const std::string& key, int variable, int kernel) {
    Term term{.op = Term::Operator::dissipation, .operand = variable};
    term.dissipation = read_plugin<abi::Dissipation>(scene, section, registry, key);
    term.kernel = kernel;
    const auto given = section.optional_real(common_key("dissipation", "alpha"));
    const double alpha = given ? *given : usual_strength(scene, term, section);
    section.resolved["alpha"] = alpha;
    term.coefficient.assign(scene.media->list().size(), alpha);
    return term;
}

Json append_dissipation(Case& scene, Section section, Registry& registry) {
    Equations& e = scene.equations;
    const int p = scene.behind(e.find("p")).variable, u = e.find("u");
    if (p < 0 || u < 0) section.fail("", "the equations have no pressure p or no velocity u to act on", "Remove the dissipation, or name them in the equations");
    if (e.dissipate()) section.fail("", "dissipation is given here and in /equations", "Remove one of the two");
    Term of_p = read_dissipation(scene, section, registry, "type", p, 0);
    section.finish();
    Term of_u{.op = of_p.op, .operand = u, .dissipation = of_p.dissipation, .coefficient = of_p.coefficient};
    e.variables[std::size_t(p)].terms.push_back(std::move(of_p));
    e.variables[std::size_t(u)].terms.push_back(std::move(of_u));
    return section.resolved;
}

void check_dissipation(const Case& scene, const Section& root) {
    const Equations& e = scene.equations;
    if (!e.dissipate()) return;
    const int p = scene.behind(e.find("p")).variable, u = e.find("u");
    for (std::size_t v = 0; v < e.variables.size(); ++v)
        for (std::size_t t = 0; t < e.variables[v].terms.size(); ++t) {
            const Term& term = e.variables[v].terms[t];
            const std::string place = root.place("equations") + "/" + e.variables[v].name + "/" + std::to_string(t);
            if (term.dissipation && int(v) != p && int(v) != u)
                throw Error(Fault::input, place + "/dissipation", "dissipation acts on sound, and \"" + e.variables[v].name + "\" is not part of it",
                            "Put the term under u or " + (p < 0 ? "p" : e.variables[std::size_t(p)].name));
            if (term.form && term.form->reach() > 0)
                throw Error(Fault::input, place + "/form", "this form's weights are made for a lattice, which needs no dissipation", "Use another form, or remove the dissipation");
        }
    const std::string remedy = "Remove the dissipation, which lattices do not need, or ";
    if (scene.neighbours == Neighbours::lattice)
        throw Error(Fault::input, root.place("particles") + "/neighbours", "\"lattice\" is a stencil, which does not do dissipation", remedy + "use \"auto\"");
    for (int a = 0; a < scene.box.dimension && scene.regular(); ++a)
        for (const bool upper : {false, true})
            if (scene.closure(a, upper) == abi::Closure::layers)
                throw Error(Fault::input, root.place("boundaries") + "/" + std::to_string(scene.boundary_of[a][upper]),
                            "its layers of virtual particles continue a stencil, which does not do dissipation", remedy + "absorb by absorbing_layer");
}

}    // namespace sphonic
