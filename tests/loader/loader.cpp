/// Each way in which a plugin library can be broken is refused with a message of its own.
#include <sphonic/plugin/abi/state.hpp>
#include <sphonic/registry.hpp>

#include "complaint.hpp"

using namespace sphonic;
using Catch::Contains;

namespace {

struct Broken {
    const char* name;    // of the library state.NAME.so
    const char* says;
};

std::unique_ptr<abi::State> create(Registry& registry, const char* name) {
    const Plugin& plugin = registry.find("state", name, "case.json: /state");
    return registry.create<abi::State>(plugin, std::vector<abi::Value>(plugin.parameters.size()));
}

}    // namespace

TEST_CASE("a sound plugin loads once and makes objects that work", "[loader]") {
    Registry registry({BROKEN_PLUGINS});
    // A stripped library has only the symbols that the dynamic loader needs.
    for (const char* name : {"sound", "stripped"}) {
        INFO(name);
        const Plugin& plugin = registry.find("state", name, "case.json: /state");
        CHECK(plugin.kind == "state");
        CHECK(plugin.name == name);
        CHECK(plugin.abi == abi_tag());
        CHECK(plugin.file.filename() == std::string("state.") + name + ".so");
        CHECK(plugin.parameters.empty());
        CHECK(&registry.find("state", name, "case.json: /state") == &plugin);
        const double x = 3;
        double y = 0;
        create(registry, name)->evaluate({}, 1, &x, &y);
        CHECK(y == 3);
    }
}

TEST_CASE("a plugin outlives the registry that loaded it", "[loader]") {
    const auto state = [] {
        Registry registry({BROKEN_PLUGINS});
        return create(registry, "sound");
    }();
    CHECK(state->derivative({}, 0) == 1);
}

TEST_CASE("a broken plugin library is refused with its file and its fault", "[loader]") {
    Registry registry({BROKEN_PLUGINS});
    const Broken libraries[] = {
        {"no_entry", "has no symbol sphonic_plugin_entry"},
        {"null_entry", "its entry function returned nothing"},
        {"throwing_entry", "its entry function failed: no licence for this plugin"},
        {"entry_throws_number", "its entry function threw something that is not an exception"},
        {"wrong_magic", "wrong magic"},
        {"wrong_size", "bytes where this sphonic has"},
        {"wrong_abi", "was built for ABI another compiler, this sphonic is"},
        {"no_abi", "was built for ABI (none)"},
        {"unknown_kind", "is of the unknown kind \"flavour\""},
        {"another_kind", "the library says it is kernel.another_kind, not what its file name says"},
        {"misnamed", "the library says it is state.another, not what its file name says"},
        {"no_factory", "its entry leaves out the kind, the name, the description or the factory"},
        {"twice_in_table", "its parameter table is broken: \"stiffness\" is there twice"},
        {"empty_range", "its parameter table is broken: the range of \"stiffness\" is empty"},
        {"default_outside", "its parameter table is broken: the default of \"stiffness\" is outside its range"},
        {"default_not_finite", "its parameter table is broken: the default of \"stiffness\" is not finite"},
        {"nameless_row", "its parameter table is broken: row 1 lacks a text"},
        {"absent_table", "its parameter table is broken: it has no rows where it claims some"},
        {"undefined_symbol", "cannot be loaded: undefined symbol: _Z7nowherev"},
        {"missing_dependency", "cannot be loaded: libsphonic_nowhere.so: cannot open shared object file"},
    };
    for (const auto& [name, says] : libraries) {
        INFO(name);
        const auto find = [&, name = name] { registry.find("state", name, "case.json: /state"); };
        const std::string message = complaint(Fault::plugin, find);
        CHECK_THAT(message, Contains(says));
        CHECK_THAT(message, Contains(std::string("state.") + name + ".so: "));
        CHECK_THAT(message, !Contains("boost") && !Contains("file descriptor"));    // no words of the machinery
        CHECK(complaint(Fault::plugin, find) == message);                           // it stays refused
    }
}

TEST_CASE("a plugin that fails to create its object is refused with its file and its fault", "[loader]") {
    Registry registry({BROKEN_PLUGINS});
    const Broken libraries[] = {
        {"throwing_create", "creating the state \"throwing_create\" failed: no licence for this state"},
        {"create_throws_number",
         "creating the state \"create_throws_number\" threw something that is not an exception"},
        {"creates_nothing", "creating the state \"creates_nothing\" returned nothing"},
    };
    for (const auto& [name, says] : libraries) {
        INFO(name);
        const std::string message = complaint(Fault::plugin, [&, name = name] { create(registry, name); });
        CHECK_THAT(message, Contains(says));
        CHECK_THAT(message, Contains(std::string("state.") + name + ".so: "));
    }
}

TEST_CASE("an unknown name is an input error at its place with the nearest name", "[loader]") {
    Registry registry({BROKEN_PLUGINS});
    const auto message = [&](const char* kind, const char* name) {
        return complaint(Fault::input, [&] { registry.find(kind, name, "case.json: /state/type"); });
    };
    CHECK_THAT(message("state", "suond"), Contains("case.json: /state/type: there is no state named \"suond\"") &&
                                              Contains("Did you mean \"sound\"?"));
    CHECK_THAT(message("state", "nothing_like_any_of_them"), Contains("Known: ") && Contains("wrong_magic"));
    CHECK_THAT(message("kernel", "sound"),
               Contains("there is no kernel named \"sound\"") && Contains("Known: none") && Contains(BROKEN_PLUGINS));
}
