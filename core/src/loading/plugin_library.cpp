/// The one file that opens shared libraries.
#define BOOST_DLL_USE_STD_FS
#include <boost/dll/shared_library.hpp>

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

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

/// A shared library read as data. Everything that its headers claim must lie inside the file: dlopen maps on their
/// word and dies of SIGBUS beyond the end, which nothing can catch.
/// (Not boost::dll::library_info: it reads .symtab, which strip removes, and takes its names from the last string table.)
class SharedObject {
public:
    explicit SharedObject(std::string_view bytes) : bytes_(bytes) {
        const auto header = at<ElfW(Ehdr)>(0);
        if (header.e_ident[EI_CLASS] != (sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32)) throw Damaged{};
        for (std::size_t i = 0; i < header.e_phnum; ++i) {
            const auto segment = at<ElfW(Phdr)>(header.e_phoff + i * sizeof(ElfW(Phdr)));
            require(segment.p_offset, segment.p_filesz);
        }
        for (std::size_t i = 0; i < header.e_shnum; ++i) {
            sections_.push_back(at<ElfW(Shdr)>(header.e_shoff + i * sizeof(ElfW(Shdr))));
            if (sections_.back().sh_type != SHT_NOBITS) require(sections_.back().sh_offset, sections_.back().sh_size);
        }
    }

    bool exports(std::string_view name) const {
        for (const auto& table : sections_) {
            if (table.sh_type != SHT_DYNSYM) continue;
            if (table.sh_link >= sections_.size()) throw Damaged{};
            const auto& strings = sections_[table.sh_link];
            const std::string_view names = bytes_.substr(strings.sh_offset, strings.sh_size);
            for (std::size_t i = 0; i < table.sh_size / sizeof(ElfW(Sym)); ++i) {
                const auto symbol = at<ElfW(Sym)>(table.sh_offset + i * sizeof(ElfW(Sym)));
                if (symbol.st_name >= names.size()) throw Damaged{};
                const auto rest = names.substr(symbol.st_name);
                if (symbol.st_shndx != SHN_UNDEF && rest.substr(0, rest.find('\0')) == name) return true;
            }
        }
        return false;
    }

    struct Damaged {};

private:
    std::string_view bytes_;
    std::vector<ElfW(Shdr)> sections_;

    void require(std::size_t offset, std::size_t size) const {
        if (offset > bytes_.size() || size > bytes_.size() - offset) throw Damaged{};
    }
    template <class T>
    T at(std::size_t offset) const {
        require(offset, sizeof(T));
        T value;
        std::memcpy(&value, bytes_.data() + offset, sizeof value);
        return value;
    }
};

/// Reads the file as data: a text file, a truncated library or a foreign one never reaches dlopen.
void inspect(const fs::path& file) {
    std::error_code failed;
    const auto size = fs::file_size(file, failed);
    if (failed) refuse(file, "cannot be read: " + failed.message(), "Check the file and its permissions");
    if (size == 0) refuse(file, "is empty", "Build the plugin again");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) refuse(file, "cannot be read", "Check the file and its permissions");
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!bytes.starts_with(ELFMAG))
        refuse(file, "is not a shared library (no ELF header)", "Build the plugin as a shared library");
    try {
        if (SharedObject(bytes).exports(abi::entry_symbol)) return;
    } catch (const SharedObject::Damaged&) {
        refuse(file, "is a damaged or truncated shared library", "Build or copy the plugin again");
    }
    refuse(file, std::string("has no symbol ") + abi::entry_symbol,
           "End the plugin's source with its macro line, such as SPHONIC_KERNEL(...)");
}

/// The dynamic loader's own words, out of "...(dlerror system message: FILE: WORDS): Bad file descriptor".
std::string words_of_loader(std::string what, const fs::path& file) {
    const std::string before = "dlerror system message: ", after = "): ";
    if (const auto begin = what.find(before); begin != std::string::npos) what.erase(0, begin + before.size());
    if (const auto end = what.rfind(after); end != std::string::npos) what.erase(end);
    const std::string named = file.string() + ": ";
    return what.starts_with(named) ? what.substr(named.size()) : what;
}

/// RTLD_NODELETE keeps the library for the life of the program: objects and texts point into it.
void open_forever(dll::shared_library& library, const fs::path& file) {
    try {
        library.load(file, dll::load_mode::rtld_now | dll::load_mode::rtld_local | dll::load_mode::type(RTLD_NODELETE));
    } catch (const std::exception& e) {
        refuse(file, "cannot be loaded: " + words_of_loader(e.what(), file),
               "Install what it needs, or build it again");
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
    dll::shared_library library;
    open_forever(library, file);
    const auto entry_of = library.get<const abi::Entry*()>(abi::entry_symbol);
    const abi::Entry* entry = nullptr;
    try {
        entry = entry_of();
    } catch (const std::exception& e) {
        refuse(file, std::string("its entry function failed: ") + e.what(), rebuild);
    } catch (...) {
        refuse(file, "its entry function threw something that is not an exception", rebuild);
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
