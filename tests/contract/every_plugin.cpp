/// What holds for plugins of every kind.
#include <sphonic/plugin/abi/arrangement.hpp>
#include <sphonic/plugin/abi/boundary.hpp>
#include <sphonic/plugin/abi/dissipation.hpp>
#include <sphonic/plugin/abi/form.hpp>
#include <sphonic/plugin/abi/integrator.hpp>
#include <sphonic/plugin/abi/kernel.hpp>
#include <sphonic/plugin/abi/method.hpp>
#include <sphonic/plugin/abi/reference.hpp>
#include <sphonic/plugin/abi/shape.hpp>
#include <sphonic/plugin/abi/source.hpp>
#include <sphonic/plugin/abi/state.hpp>
#include <sphonic/plugin/abi/viscosity.hpp>

#include <set>

#include "subjects.hpp"

using namespace sphonic;
using namespace sphonic::contract;

namespace {

/// Creates every plugin of these kinds; returns the kinds.
template <class... Interface>
std::set<std::string> create_all() {
    (subjects<Interface>(), ...);
    return {Interface::kind...};
}

}    // namespace

TEST_CASE("a plugin can be created with its defaults and at the ends of its ranges", "[plugin]") {
    const auto created = create_all<abi::Arrangement, abi::Boundary, abi::Dissipation, abi::Form, abi::Integrator, abi::Kernel,
                                    abi::Method, abi::Reference, abi::Shape, abi::Source, abi::State, abi::Viscosity>();
    const auto kinds = plugin_kinds();
    CHECK(created == std::set<std::string>(kinds.begin(), kinds.end()));
}

TEST_CASE("a plugin describes itself and each of its parameters", "[plugin]") {
    for (const auto& [kind, name] : registry().found()) {
        INFO(kind << "." << name);
        const Plugin& plugin = registry().find(kind, name, "contract");
        CHECK_FALSE(plugin.doc.empty());
        for (const auto& row : plugin.parameters) {
            INFO(row.name);
            CHECK_FALSE(std::string(row.unit).empty());
            CHECK_FALSE(std::string(row.doc).empty());
        }
    }
}
