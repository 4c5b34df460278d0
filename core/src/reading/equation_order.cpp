#include <utility>

#include <sphonic/error.hpp>

#include "equation_reader.hpp"

namespace sphonic {
namespace {

void read_given_order(Equations& e, const Json& order, const Section& section) {
    const std::string remedy = "Write lists of evolved variables, each once, such as [[\"u\"], [\"p\", \"x\"]]";
    std::vector<int> seen(e.variables.size(), 0);
    bool x_seen = false;
    if (!order.is_array()) section.fail("order", shown(order) + " is not a list", remedy);
    for (const Json& group : order) {
        if (!group.is_array() || group.empty()) section.fail("order", shown(group) + " is not a list with entries", remedy);
        e.order.emplace_back();
        for (const Json& name : group) {
            const std::string text = name.is_string() ? name.get<std::string>() : "";
            if (text == "x" && !std::exchange(x_seen, true)) {
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

}    // namespace

void read_order(Equations& e, Section& section) {
    if (const Json* order = section.find("order")) {
        read_given_order(e, *order, section);
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

}    // namespace sphonic
