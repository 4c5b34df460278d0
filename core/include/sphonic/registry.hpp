#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <sphonic/plugin/abi/entry.hpp>

namespace sphonic {

/// A loaded plugin: what its entry says, and the file it came from. Libraries are never unloaded.
struct Plugin {
    std::string kind, name, doc, abi;
    std::filesystem::path file;
    std::span<const abi::ParameterInfo> parameters;
    void* (*create)(const abi::Value*) = nullptr;
};

/// Finds plugins by file name (KIND.NAME.so) and loads only those that are asked for.
class Registry {
public:
    /// Folders are searched together: the same file name in two of them is an error that names both.
    explicit Registry(std::vector<std::filesystem::path> folders);

    /// `extra` first, then SPHONIC_PLUGIN_PATH (colon-separated), then the folder that belongs to this program.
    static std::vector<std::filesystem::path> search_path(const std::vector<std::filesystem::path>& extra = {});

    /// Loads on first use. An unknown name is an input error at `place` with the nearest name;
    /// a library that cannot be trusted is a plugin error that says why.
    const Plugin& find(const std::string& kind, const std::string& name, const std::string& place);

    /// A new object of the plugin, one value per table row.
    template <class Interface>
    std::unique_ptr<Interface> create(const Plugin& plugin, const std::vector<abi::Value>& values) {
        return std::unique_ptr<Interface>(static_cast<Interface*>(make(plugin, values)));
    }

    /// Every plugin file found, as (kind, name), sorted.
    std::vector<std::pair<std::string, std::string>> found() const;
    std::vector<std::string> names(const std::string& kind) const;

private:
    using Key = std::pair<std::string, std::string>;
    std::vector<std::filesystem::path> folders_;
    std::map<Key, std::vector<std::filesystem::path>> files_;
    std::map<Key, Plugin> loaded_;

    void* make(const Plugin& plugin, const std::vector<abi::Value>& values);
};

/// The kinds that the runtime knows.
std::span<const std::string> plugin_kinds();

/// Opens one library file and checks all that can be checked before its code is trusted.
Plugin load_plugin(const std::filesystem::path& file);

/// The tag that a plugin must carry: headers of plugin/abi, compiler ABI, flags.
const char* abi_tag();

}    // namespace sphonic
