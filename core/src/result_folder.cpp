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

fs::path ResultFolder::unused(const std::string& name) {
    fs::path folder = fs::path("runs") / name;
    for (int i = 2; fs::exists(folder); ++i) folder = fs::path("runs") / (name + "-" + std::to_string(i));
    return folder;
}

ResultFolder::ResultFolder(fs::path target, bool force) : target_(std::move(target)), force_(force) {
    if (target_.filename().empty()) target_ = target_.parent_path();
    if (fs::exists(target_) && !force)
        throw Error(Fault::io, target_.string(), "exists already", "Give --force to replace it, or another --out");
    temporary_ = target_.parent_path() / ("." + target_.filename().string() + "." + std::to_string(::getpid()) + ".part");
    std::error_code failed;
    fs::remove_all(temporary_, failed);
    fs::create_directories(temporary_, failed);
    if (failed) throw Error(Fault::io, target_.string(), "cannot be created: " + failed.message(), "Check space and permissions");
}

ResultFolder::~ResultFolder() {
    std::error_code ignored;
    if (!committed_) fs::remove_all(temporary_, ignored);
}

void ResultFolder::write(const std::string& name, const std::string& text) const { write_file(temporary_ / name, text); }

void ResultFolder::commit() {
    std::error_code failed;
    const fs::path old = temporary_.string() + ".old";
    if (force_ && fs::exists(target_)) fs::rename(target_, old, failed);
    if (!failed) fs::rename(temporary_, target_, failed);
    if (failed) throw Error(Fault::io, target_.string(), "cannot be put in place: " + failed.message(), "Check space and permissions");
    committed_ = true;
    fs::remove_all(old, failed);
}

}    // namespace sphonic
