#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <regex>

#include <unistd.h>

#include <sphonic/error.hpp>
#include <sphonic/json.hpp>
#include <sphonic/registry.hpp>

#include "commands.hpp"
#include "found_plugins.hpp"
#include "scaffolds.hpp"

namespace fs = std::filesystem;

namespace sphonic::driver {
namespace {

/// The source tree around this folder, or nothing.
fs::path source_tree() {
    for (fs::path here = fs::current_path();; here = here.parent_path()) {
        if (fs::exists(here / "plugins/CMakeLists.txt") && fs::is_directory(here / "core/include/sphonic/plugin")) return here;
        if (here == here.parent_path()) return {};
    }
}

/// "kernels", "viscosities".
std::string folder_of(const std::string& kind) {
    return kind.ends_with('y') ? kind.substr(0, kind.size() - 1) + "ies" : kind + "s";
}

void require_free_name(const std::string& kind, const std::string& name, Registry& registry) {
    static const std::regex snake("[a-z][a-z0-9]*(_[a-z0-9]+)*");
    if (!std::regex_match(name, snake))
        throw Error(Fault::input, "new", "\"" + name + "\" is not a plugin's name",
                    "Use lower_snake_case: letters, digits and single underscores, a letter first");
    const auto names = registry.names(kind);
    if (std::find(names.begin(), names.end(), name) == names.end()) return;
    const fs::path file = registry.find(kind, name, "new").file;
    throw Error(Fault::input, "new", "there is a " + kind + " \"" + name + "\" already, in " + file.string(), "Choose another name");
}

/// Opens with "x": whatever stands there already, even a link that leads nowhere, stays as it is.
void write_new(const fs::path& file, const std::string& text) {
    const auto refuse = [&](const std::string& problem, const char* remedy) { throw Error(Fault::io, file.string(), problem, remedy); };
    std::FILE* out = std::fopen(file.c_str(), "wxe");
    if (!out && errno == EEXIST) refuse("exists already", "Choose another name");
    if (!out) refuse(std::string("cannot be written: ") + std::strerror(errno), "Check space and permissions");
    const bool written = std::fwrite(text.data(), 1, text.size(), out) == text.size();
    if (std::fclose(out) == 0 && written) return;
    const int reason = errno;
    ::unlink(file.c_str());
    refuse(std::string("cannot be written: ") + std::strerror(reason), "Check space and permissions");
}

/// The commands of a new plugin's first minutes; `tree` is empty if its source lies outside one.
std::vector<std::string> next_steps(const std::string& kind, const std::string& name, const Scaffold& made, const fs::path& tree) {
    const std::string plugin = kind + " " + name;
    const std::string option = " --set " + (made.set.find('{') == made.set.npos ? made.set : "'" + made.set + "'");
    if (tree.empty()) {
        const std::string path = " --plugin-path FOLDER";
        return {"build it through the CMake target sphonic::plugin as FOLDER/" + kind + "." + name + ".so, or move it to plugins/" +
                    folder_of(kind) + " of the source tree, where apps/sphonic builds it",
                "sphonic describe " + plugin + path, "sphonic check " + made.scene + option + path};
    }
    const auto from_here = [&](const std::string& file) { return (tree / file).lexically_proximate(fs::current_path()).string(); };
    const std::string sphonic = from_here("apps/sphonic");
    return {sphonic + " describe " + plugin + "    builds it and shows its parameters",
            sphonic + " check " + from_here(made.scene) + option,
            sphonic + " test -R contract    the laws that every plugin obeys"};
}

}    // namespace

int new_plugin(const Common& options, const std::string& kind, const std::string& name, const fs::path& folder) {
    require_kind(kind, "new");
    Registry registry(Registry::search_path(options.plugin_path));
    require_free_name(kind, name, registry);
    const auto made = scaffold(kind, name);
    if (!made) throw Error(Fault::input, "new", "there is no scaffold for the kind " + kind, "Copy another plugin of the kind");

    const fs::path tree = source_tree(), home = tree / "plugins" / folder_of(kind);
    if (folder.empty() && tree.empty())
        throw Error(Fault::input, "new", "this folder is not in a source tree of sphonic", "Go there, or give --dir");
    if (!folder.empty() && !fs::is_directory(folder))
        throw Error(Fault::input, "--dir", folder.string() + " is not a folder", "Give an existing one");
    std::error_code elsewhere;
    const bool at_home = folder.empty() || fs::equivalent(folder, home, elsewhere);
    const fs::path file = (folder.empty() ? home.lexically_proximate(fs::current_path()) : folder) / (name + ".cpp");
    write_new(file, made->source);

    const auto steps = next_steps(kind, name, *made, at_home ? tree : fs::path());
    if (options.json) {
        std::cout << json_text({{"kind", kind}, {"name", name}, {"file", file.string()}, {"set", made->set}, {"scene", made->scene}, {"next", steps}});
        return 0;
    }
    std::printf("%s\nNext:\n", file.c_str());
    for (const std::string& step : steps) std::printf("  %s\n", step.c_str());
    return 0;
}

}    // namespace sphonic::driver
