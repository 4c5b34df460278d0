#pragma once
/// The parts of reading a case; each takes its piece of the document and the case as read so far.

#include <stdexcept>

#include <sphonic/case.hpp>
#include <sphonic/error.hpp>

#include "section.hpp"

namespace sphonic {

/// Records path, version and ABI of a plugin in use under /provenance.
void note_provenance(Case& scene, const Plugin& plugin);

/// `imposes`: of a source that sets values.
void obey_key_rules(Section& section, const std::string& kind, const Case& scene, bool imposes = false);

/// Refuses lists in `section` for rows of vectors whose length is not the dimension.
void require_fitting_vectors(const Section& section, const Plugin& plugin, int dimension);

/// The plugin named by `key` inside `section`, made with the parameters that stand in the same object.
template <class Interface>
std::unique_ptr<Interface> read_plugin(Case& scene, Section& section, Registry& registry, const std::string& key = "type") {
    const std::string kind = Interface::kind;
    const Json& name = section.need(key, "Name a " + kind + ": " + join(registry.names(kind)));
    if (!name.is_string()) section.fail(key, shown(name) + " is not a string", "Name a " + kind);
    const Plugin& plugin = registry.find(kind, section.text(key, ""), section.place(key));
    note_provenance(scene, plugin);
    const auto values = section.read(plugin.parameters);
    require_fitting_vectors(section, plugin, scene.box.dimension);
    return registry.create<Interface>(plugin, values);
}

/// A plugin with all its defaults.
template <class Interface>
std::unique_ptr<Interface> default_plugin(Case& scene, Registry& registry, const std::string& name, const std::string& place) {
    const Plugin& plugin = registry.find(Interface::kind, name, place);
    note_provenance(scene, plugin);
    static const Json nothing = Json::object();
    return registry.create<Interface>(plugin, Section(nothing, place, "").read(plugin.parameters));
}

/// Translates what a plugin says of its parameters into an error at the plugin's place.
template <class Call>
void prepared(const std::string& place, Call call) {
    try {
        call();
    } catch (const std::invalid_argument& e) {
        throw Error(Fault::input, place, e.what());
    }
}

/// c0, rho0 and K of a medium, dx and, where there is a default kernel, h.
Expression::Constants constants(const Case& scene, const abi::Medium& medium);
/// Those of the first medium.
Expression::Constants constants(const Case& scene);

void read_space(Case& scene, Section& root, Registry& registry);        // particles, boundaries
void read_media(Case& scene, Section& root);                              // medium: one, or a list, of which the first fills the box, the others their regions
void lay_out(Case& scene, const Section& root);                           // counts the particles, once the media's spacings are known
void read_kernels(Case& scene, Section& root, Registry& registry);      // kernel, kernels
void read_equations(Case& scene, Section& root, Registry& registry);    // equations, viscosity, dissipation
void read_obstacles(Case& scene, Section& root, Registry& registry);    // obstacles, once the kernels and so h are known
void read_reference(Case& scene, Section& root, Registry& registry);    // reference; sources may take their field from it
void read_sources(Case& scene, Section& root, Registry& registry);      // sources
void prepare_reference(Case& scene, const Section& root);                // with the sources' waves
void read_initial(Case& scene, Section& root);                            // initial
void read_time(Case& scene, Section& root, Registry& registry);         // integrator, until
void read_output(Case& scene, Section& root);                             // output

}    // namespace sphonic
