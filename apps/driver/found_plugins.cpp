#include "found_plugins.hpp"

#include <algorithm>

#include <sphonic/error.hpp>
#include <sphonic/log.hpp>
#include <sphonic/nearest.hpp>

namespace sphonic::driver {

int FoundPlugins::exit_code() const { return refused ? int(Fault::plugin) : 0; }

FoundPlugins load_found(Registry& registry, const std::string& place, const std::string& kind) {
    FoundPlugins found;
    for (const auto& [its_kind, name] : registry.found()) {
        if (!kind.empty() && its_kind != kind) continue;
        try {
            found.plugins.push_back(&registry.find(its_kind, name, place));
        } catch (const Error& e) {
            log::error(e.what());
            ++found.refused;
        }
    }
    return found;
}

void require_kind(const std::string& kind, const std::string& place) {
    const auto kinds = plugin_kinds();
    if (std::ranges::find(kinds, kind) != kinds.end()) return;
    std::string known;
    for (const std::string& k : kinds) known += (known.empty() ? "" : ", ") + k;
    const std::string near = nearest(kind, kinds);
    throw Error(Fault::input, place, "there is no plugin kind \"" + kind + "\"",
                near.empty() ? "Known: " + known : "Did you mean \"" + near + "\"?");
}

}    // namespace sphonic::driver
