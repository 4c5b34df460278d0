#include <sphonic/result_folder.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>

#include <unistd.h>

#include <sphonic/error.hpp>

namespace fs = std::filesystem;

namespace sphonic {

void write_file(const fs::path& file, const std::string& text) {
    errno = 0;
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw Error(Fault::io, file.string(), std::string("cannot be written: ") + std::strerror(errno), "Check space and permissions");
}

namespace {

bool is_there(const fs::path& path) {
    std::error_code failed;
    const bool there = fs::exists(path, failed);
    if (failed) throw Error(Fault::io, path.string(), "cannot be looked at: " + failed.message(), "Check permissions");
    return there;
}

/// --force replaces earlier results, never anything else.
void refuse_foreign(const fs::path& target) {
    std::error_code failed;
    const bool folder = fs::is_directory(target, failed);
    if (folder && (fs::is_empty(target, failed) || is_there(target / "summary.json") || is_there(target / "resolved.json"))) return;
    throw Error(Fault::io, target.string(), "holds something other than results of a run", "Give another --out");
}

}    // namespace

fs::path ResultFolder::unused(const std::string& name) {
    fs::path folder = fs::path("runs") / name;
    for (int i = 2; is_there(folder); ++i) folder = fs::path("runs") / (name + "-" + std::to_string(i));
    return folder;
}

ResultFolder::ResultFolder(fs::path target, bool force) : target_(std::move(target)), force_(force) {
    target_ = target_.lexically_normal();
    if (target_.filename().empty()) target_ = target_.parent_path();
    if (is_there(target_)) {
        if (!force) throw Error(Fault::io, target_.string(), "exists already", "Give --force to replace it, or another --out");
        refuse_foreign(target_);
    }
    temporary_ = target_.parent_path() / ("." + target_.filename().string() + "." + std::to_string(::getpid()) + ".part");
    for (fs::path parent = target_.parent_path(); !parent.empty() && !is_there(parent); parent = parent.parent_path())
        made_.push_back(parent);
    std::error_code failed;
    fs::remove_all(temporary_, failed);
    fs::create_directories(temporary_, failed);
    if (failed) throw Error(Fault::io, target_.string(), "cannot be created: " + failed.message(), "Check space and permissions");
}

ResultFolder::~ResultFolder() {
    std::error_code ignored;
    if (committed_) return;
    fs::remove_all(temporary_, ignored);
    for (const fs::path& parent : made_) fs::remove(parent, ignored);    // only if empty
}

void ResultFolder::write(const std::string& name, const std::string& text) const { write_file(temporary_ / name, text); }

void ResultFolder::commit() {
    std::error_code failed;
    const fs::path old = temporary_.string() + ".old";
    std::error_code ignored;
    const bool replaces = force_ && is_there(target_);
    if (replaces) fs::rename(target_, old, failed);
    if (!failed) {
        fs::rename(temporary_, target_, failed);
        if (failed && replaces) fs::rename(old, target_, ignored);
    }
    if (failed) throw Error(Fault::io, target_.string(), "cannot be put in place: " + failed.message(), "Check space and permissions");
    committed_ = true;
    fs::remove_all(old, ignored);
}

}    // namespace sphonic
