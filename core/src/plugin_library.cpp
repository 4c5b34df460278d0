/// The one file that opens shared libraries.
#define BOOST_DLL_USE_STD_FS
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <vector>

#include <boost/dll/library_info.hpp>    // does not include <vector> itself
#include <boost/dll/shared_library.hpp>

#include <sphonic/error.hpp>
#include <sphonic/registry.hpp>

namespace fs = std::filesystem;
namespace dll = boost::dll;

namespace sphonic {
namespace {

[[noreturn]] void refuse(const fs::path& file, const std::string& why, const std::string& remedy) {
    throw Error(Fault::plugin, file.string(), why, remedy);
}

const std::string rebuild = "Build it again against this sphonic, through the CMake target sphonic::plugin";

/// Reads the file as data: a text file, a truncated library or a foreign one never reaches dlopen.
void inspect(const fs::path& file) {
    std::error_code failed;
    const auto size = fs::file_size(file, failed);
    if (failed) refuse(file, "cannot be read: " + failed.message(), "Check the file and its permissions");
    if (size == 0) refuse(file, "is empty", "Build the plugin again");
    char head[4] = {};
    std::ifstream(file, std::ios::binary).read(head, sizeof head);
    if (std::memcmp(head, "\177ELF", 4) != 0)
        refuse(file, "is not a shared library (no ELF header)", "Build the plugin as a shared library");
    std::vector<std::string> symbols;
    try {
        symbols = dll::library_info(file, true).symbols();
    } catch (const std::exception&) {
        refuse(file, "is a damaged or truncated shared library", "Build or copy the plugin again");
    }
    if (std::find(symbols.begin(), symbols.end(), abi::entry_symbol) == symbols.end())
        refuse(file, std::string("has no symbol ") + abi::entry_symbol,
               "End the plugin's source with its macro line, such as SPHONIC_KERNEL(...)");
}

/// The truth about a failure is in what(); the code's own message is junk.
void open_forever(dll::shared_library& library, const fs::path& file) {
    try {
        library.load(file, dll::load_mode::rtld_now | dll::load_mode::rtld_local);
    } catch (const std::exception& e) {
        std::string why = e.what();
        const auto named = why.find(file.string());
        if (named != std::string::npos) why = why.substr(named + file.string().size());
        while (!why.empty() && (why[0] == ':' || why[0] == ' ')) why.erase(0, 1);
        refuse(file, "cannot be loaded: " + why, "Install what it needs, or build it again");
    }
}

void check_entry(const fs::path& file, const abi::Entry* entry) {
    if (!entry) refuse(file, "its entry function returned nothing", rebuild);
    if (std::memcmp(entry->magic, abi::magic, sizeof abi::magic) != 0)
        refuse(file, "is not a sphonic plugin: its entry carries the wrong magic", rebuild);
    if (entry->size != sizeof(abi::Entry))
        refuse(file,
               "its entry has " + std::to_string(entry->size) + " bytes where this sphonic has " +
                   std::to_string(sizeof(abi::Entry)),
               rebuild);
    if (!entry->abi || std::strcmp(entry->abi, abi_tag()) != 0)
        refuse(file,
               std::string("was built for ABI ") + (entry->abi ? entry->abi : "(none)") + ", this sphonic is " +
                   abi_tag(),
               rebuild);
    if (!entry->kind || !entry->name || !entry->doc || !entry->create || !entry->name[0])
        refuse(file, "its entry leaves out the kind, the name, the description or the factory", rebuild);
    const auto kinds = plugin_kinds();
    if (std::find(kinds.begin(), kinds.end(), entry->kind) == kinds.end())
        refuse(file, std::string("is of the unknown kind \"") + entry->kind + "\"", rebuild);
}

void check_table(const fs::path& file, const abi::Entry& entry) {
    const auto broken = [&](const std::string& why) { refuse(file, "its parameter table is broken: " + why, rebuild); };
    if (entry.parameter_count < 0 || (entry.parameter_count > 0 && !entry.parameters))
        broken("it has no rows where it claims some");
    for (int i = 0; i < entry.parameter_count; ++i) {
        const abi::ParameterInfo& row = entry.parameters[i];
        if (!row.name || !row.name[0] || !row.unit || !row.doc || !row.choices)
            broken("row " + std::to_string(i) + " lacks a text");
        const std::string name = row.name;
        for (int j = 0; j < i; ++j)
            if (name == entry.parameters[j].name) broken("\"" + name + "\" is there twice");
        if (!(row.lower <= row.upper)) broken("the range of \"" + name + "\" is empty");
        const bool numeric =
            row.initial.type == abi::ParameterType::real || row.initial.type == abi::ParameterType::integer;
        const double initial =
            row.initial.type == abi::ParameterType::real ? row.initial.real : double(row.initial.integer);
        if (numeric && !std::isfinite(initial)) broken("the default of \"" + name + "\" is not finite");
        if (numeric && initial != 0 && (initial < row.lower || initial > row.upper))
            broken("the default of \"" + name + "\" is outside its range");
    }
}

}    // namespace

const char* abi_tag() { return SPHONIC_ABI_TAG; }

Plugin load_plugin(const fs::path& file) {
    inspect(file);
    auto* library = new dll::shared_library;    // kept for the life of the program: objects and texts point into it
    open_forever(*library, file);
    const auto entry_of = library->get<const abi::Entry*()>(abi::entry_symbol);
    const abi::Entry* entry = nullptr;
    try {
        entry = entry_of();
    } catch (const std::exception& e) {
        refuse(file, std::string("its entry function failed: ") + e.what(), rebuild);
    }
    check_entry(file, entry);
    check_table(file, *entry);
    return {.kind = entry->kind,
            .name = entry->name,
            .doc = entry->doc,
            .abi = entry->abi,
            .file = file,
            .parameters = {entry->parameters, std::size_t(entry->parameter_count)},
            .create = entry->create};
}

}    // namespace sphonic
