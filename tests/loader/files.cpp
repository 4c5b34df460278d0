/// Files that are no plugins at all, truncated ones, and the folders in which plugins are sought.
#include <link.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include <sphonic/registry.hpp>

#include "complaint.hpp"

using namespace sphonic;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A folder of its own for a test, gone afterwards.
struct Folder {
    fs::path path;

    Folder() {
        std::string name = (fs::temp_directory_path() / "sphonic_loader.XXXXXX").string();
        REQUIRE(mkdtemp(name.data()));
        path = fs::canonical(name);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { fs::remove_all(path); }

    fs::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path / name, std::ios::binary) << bytes;
        return path / name;
    }
};

std::string sound_library() {
    std::ifstream file(fs::path(BROKEN_PLUGINS) / "state.sound.so", std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    REQUIRE(bytes.size() > 1000);
    return bytes;
}

/// What is said of a file with these bytes.
std::string complaint_about(const std::string& bytes) {
    const Folder folder;
    const fs::path file = folder.write("state.given.so", bytes);
    Registry registry({folder.path});
    std::string message = complaint(Fault::plugin, [&] { registry.find("state", "given", "case.json: /state"); });
    CHECK_THAT(message, Catch::StartsWith(file.string() + ": "));
    return message;
}

template <class T>
T read_at(const std::string& bytes, std::size_t offset) {
    T value;
    REQUIRE(offset + sizeof value <= bytes.size());
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

}    // namespace

TEST_CASE("a file that is no shared library is refused before it is loaded", "[loader]") {
    CHECK_THAT(complaint_about(""), Contains("is empty"));
    CHECK_THAT(complaint_about("int main() {}\n"), Contains("is not a shared library"));
    CHECK_THAT(complaint_about("\177EL"), Contains("is not a shared library"));
    CHECK_THAT(complaint_about("\177ELF and so on, but not an executable and linkable format"),
               Contains("is a damaged or truncated shared library"));
}

TEST_CASE("a library truncated anywhere is refused before it is loaded", "[loader]") {
    const std::string whole = sound_library();
    std::vector<std::size_t> cuts{4, 15, 16, 63, 64, 65, whole.size() - 1};
    for (std::size_t cut = 97; cut < whole.size(); cut += 97) cuts.push_back(cut);
    for (std::size_t page = 4096; page < whole.size(); page += 4096) cuts.push_back(page);
    for (const std::size_t cut : cuts) {
        INFO(cut << " of " << whole.size() << " bytes");
        CHECK_THAT(complaint_about(whole.substr(0, cut)), Contains("is a damaged or truncated shared library"));
    }
}

TEST_CASE("a library whose headers claim more than the file holds is refused before it is loaded", "[loader]") {
    // So looks a file whose tables lie in front of what was cut off. Mapped by the loader, it ends the process.
    std::string bytes = sound_library();
    const auto header = read_at<ElfW(Ehdr)>(bytes, 0);
    for (std::size_t i = header.e_phnum; i-- > 0;) {
        const std::size_t place = header.e_phoff + i * sizeof(ElfW(Phdr));
        auto segment = read_at<ElfW(Phdr)>(bytes, place);
        if (segment.p_type != PT_LOAD) continue;    // the last one may grow without reaching another
        segment.p_filesz += bytes.size() + 65536;
        segment.p_memsz = segment.p_filesz + 8;
        std::memcpy(bytes.data() + place, &segment, sizeof segment);
        break;
    }
    CHECK_THAT(complaint_about(bytes), Contains("is a damaged or truncated shared library"));
}

TEST_CASE("a folder in the place of a plugin file is refused", "[loader]") {
    const Folder folder;
    fs::create_directory(folder.path / "state.given.so");
    Registry registry({folder.path});
    CHECK_THAT(complaint(Fault::plugin, [&] { registry.find("state", "given", "case.json: /state"); }),
               Contains("cannot be read"));
}

TEST_CASE("the same plugin in two folders is an error that names both files", "[loader]") {
    const Folder one, another;
    const fs::path first = one.write("state.twin.so", ""), second = another.write("state.twin.so", "");
    Registry registry({one.path, another.path});
    CHECK_THAT(complaint(Fault::plugin, [&] { registry.find("state", "twin", "case.json: /state"); }),
               Contains(first.string()) && Contains(second.string()) && Contains("also in"));
}

TEST_CASE("the same folder named twice holds each plugin once", "[loader]") {
    const fs::path folder = BROKEN_PLUGINS;
    Registry registry({folder, folder / ".." / folder.filename()});
    CHECK(registry.find("state", "sound", "case.json: /state").name == "sound");
}

TEST_CASE("a plugin folder that does not exist is an error", "[loader]") {
    const Folder folder;
    CHECK_THAT(complaint(Fault::plugin, [&] { Registry({folder.path / "missing"}); }),
               Contains((folder.path / "missing").string() + ": this plugin folder does not exist"));
}

TEST_CASE("only files named KIND.NAME.so are plugins and none is opened before it is asked for", "[loader]") {
    const Folder folder;
    for (const char* name : {"state.b.so", "state.a.so", "kernel.c.so", "libstate.so", "state.so", ".so", "state.a.txt",
                             "README.md", "state.a.so.bak"})
        folder.write(name, "nothing that could be loaded");
    const Registry registry({folder.path});
    using Found = std::vector<std::pair<std::string, std::string>>;
    CHECK(registry.found() == Found{{"kernel", "c"}, {"state", "a"}, {"state", "b"}});
    CHECK(registry.names("state") == std::vector<std::string>{"a", "b"});
    CHECK(registry.names("viscosity").empty());
}

TEST_CASE("plugins are sought in given folders then in SPHONIC_PLUGIN_PATH then beside the program", "[loader]") {
    const char* set = std::getenv("SPHONIC_PLUGIN_PATH");
    const std::string before = set ? set : "";
    setenv("SPHONIC_PLUGIN_PATH", "/second::/third", 1);
    const auto folders = Registry::search_path({"/first"});
    setenv("SPHONIC_PLUGIN_PATH", before.c_str(), 1);

    REQUIRE(folders.size() >= 4);
    CHECK(folders[0] == "/first");
    CHECK(folders[1] == "/second");
    CHECK(folders[2] == "/third");
    CHECK(folders[3] == fs::canonical(fs::read_symlink("/proc/self/exe").parent_path() / "../plugins"));
}
