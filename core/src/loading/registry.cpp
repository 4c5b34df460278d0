#include <sphonic/registry.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

#include <sphonic/error.hpp>
#include <sphonic/nearest.hpp>

namespace fs = std::filesystem;

namespace sphonic {
namespace {

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

std::string listed(const std::vector<fs::path>& folders) {
    std::vector<std::string> names;
    for (const auto& folder : folders) names.push_back(folder.string());
    return listed(names);
}

/// "kernel.cubic_spline.so" -> (kernel, cubic_spline); an empty kind if the name is not of that shape.
std::pair<std::string, std::string> split_name(const fs::path& file) {
    const std::string name = file.filename().string();
    const auto dot = name.find('.');
    if (file.extension() != ".so" || dot == std::string::npos || dot + 3 >= name.size() || name.starts_with("lib"))
        return {};
    return {name.substr(0, dot), name.substr(dot + 1, name.size() - dot - 4)};
}

fs::path program_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

}    // namespace

std::span<const std::string> plugin_kinds() {
    static const std::array<std::string, 12> kinds{"arrangement", "boundary",  "dissipation", "form",   "integrator", "kernel",
                                                   "method",      "reference", "shape",       "source", "state",      "viscosity"};
    return kinds;
}

std::vector<fs::path> Registry::search_path(const std::vector<fs::path>& extra) {
    std::vector<fs::path> folders = extra;
    if (const char* environment = std::getenv("SPHONIC_PLUGIN_PATH")) {
        std::istringstream parts(environment);
        for (std::string part; std::getline(parts, part, ':');)
            if (!part.empty()) folders.emplace_back(part);
    }
    const fs::path here = program_folder();
    for (const fs::path& own : {here / "../plugins", here / "../lib/sphonic/plugins"})
        if (fs::is_directory(own)) folders.push_back(fs::canonical(own));
    return folders;
}

Registry::Registry(std::vector<fs::path> folders) {
    for (fs::path& folder : folders) {
        if (!fs::is_directory(folder))
            throw Error(Fault::plugin, folder.string(), "this plugin folder does not exist",
                        "Give an existing folder to --plugin-path or SPHONIC_PLUGIN_PATH");
        folder = fs::canonical(folder);
        if (std::find(folders_.begin(), folders_.end(), folder) != folders_.end()) continue;
        folders_.push_back(folder);
        for (const auto& file : fs::directory_iterator(folder))
            if (const Key key = split_name(file.path()); !key.first.empty()) files_[key].push_back(file.path());
    }
}

std::vector<std::pair<std::string, std::string>> Registry::found() const {
    std::vector<Key> keys;
    for (const auto& [key, file] : files_) keys.push_back(key);
    return keys;
}

std::vector<std::string> Registry::names(const std::string& kind) const {
    std::vector<std::string> names;
    for (const auto& [key, file] : files_)
        if (key.first == kind) names.push_back(key.second);
    return names;
}

const Plugin& Registry::find(const std::string& kind, const std::string& name, const std::string& place) {
    const Key key{kind, name};
    if (const auto known = loaded_.find(key); known != loaded_.end()) return known->second;
    const auto entry = files_.find(key);
    if (entry == files_.end()) {
        const auto known = names(kind);
        const std::string near = nearest(name, known);
        throw Error(Fault::input, place, "there is no " + kind + " named \"" + name + "\"",
                    near.empty() ? "Known: " + listed(known) + " (searched " + listed(folders_) + ")"
                                 : "Did you mean \"" + near + "\"?");
    }
    const auto& files = entry->second;
    if (files.size() > 1)
        throw Error(Fault::plugin, files[0].string(),
                    "the " + kind + " \"" + name + "\" is also in " + files[1].string(),
                    "Remove or rename one of the two");
    Plugin plugin = load_plugin(files[0]);
    if (plugin.kind != kind || plugin.name != name)
        throw Error(Fault::plugin, files[0].string(),
                    "the library says it is " + plugin.kind + "." + plugin.name + ", not what its file name says",
                    "Rename the file to " + plugin.kind + "." + plugin.name + ".so");
    return loaded_.emplace(key, std::move(plugin)).first->second;
}

void* Registry::make(const Plugin& plugin, const std::vector<abi::Value>& values) {
    const std::string what = plugin.kind + " \"" + plugin.name + "\"";
    void* object = nullptr;
    try {
        object = plugin.create(values.data());
    } catch (const std::exception& e) {
        throw Error(Fault::plugin, plugin.file.string(), "creating the " + what + " failed: " + e.what(),
                    "This is a fault of the plugin");
    } catch (...) {
        throw Error(Fault::plugin, plugin.file.string(),
                    "creating the " + what + " threw something that is not an exception",
                    "This is a fault of the plugin");
    }
    if (!object)
        throw Error(Fault::plugin, plugin.file.string(), "creating the " + what + " returned nothing",
                    "This is a fault of the plugin");
    return object;
}

}    // namespace sphonic
