#include "group_parts.hpp"

namespace sphonic {

GroupParts::GroupParts(const Case& scene, const Components& of, std::vector<int> variables, bool positions)
    : variables(std::move(variables)), positions(positions && of.positions >= 0) {
    for (const int v : this->variables)
        for (int c = 0; c < scene.equations.variables[std::size_t(v)].components(scene.box.dimension); ++c)
            components.push_back(of.first[std::size_t(v)] + c);
    reads_itself = reads(scene);
}

bool GroupParts::reads(const Case& scene) const {
    const auto within = [&](int v) { return has(scene.behind(v).variable); };
    for (const int v : variables)
        for (const Term& term : scene.equations.variables[std::size_t(v)].terms) {
            if (within(term.operand)) return true;
            if (!term.fitted.empty() && !scene.on_lattice()) return true;    // it damps its own variable
            for (const Factor& f : term.factors)
                if (within(f.variable)) return true;
        }
    return positions && within(scene.equations.velocity);
}

std::vector<GroupParts> GroupParts::all(const Case& scene, const Components& of) {
    std::vector<GroupParts> parts;
    std::vector<int> every;
    for (std::size_t g = 0; g < scene.equations.order.size(); ++g) {
        const auto& group = scene.equations.order[g];
        parts.push_back({scene, of, group, int(g) == scene.equations.positions_group});
        every.insert(every.end(), group.begin(), group.end());
    }
    std::sort(every.begin(), every.end());
    parts.push_back({scene, of, every, true});
    parts.push_back({scene, of, every, false});
    parts.push_back({scene, of, {}, true});
    return parts;
}

}    // namespace sphonic
