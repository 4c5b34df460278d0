#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace sphonic {

/// An output folder that appears whole or not at all: files go to a hidden neighbour, which `commit` renames.
class ResultFolder {
public:
    /// Refuses to replace an existing folder unless `force`, and with it anything but earlier results.
    ResultFolder(std::filesystem::path target, bool force);
    /// Takes the files back if `commit` was not reached.
    ~ResultFolder();
    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    /// Where to write now.
    const std::filesystem::path& path() const { return temporary_; }
    const std::filesystem::path& target() const { return target_; }
    void write(const std::string& name, const std::string& text) const;
    void commit();

    /// `runs/NAME`, or `runs/NAME-2` and so on if that exists.
    static std::filesystem::path unused(const std::string& name);

private:
    std::filesystem::path target_, temporary_;
    std::vector<std::filesystem::path> made_;    ///< parents that were not there before, innermost first
    bool force_, committed_ = false;
};

/// Writes a file whole; a full disk or a forbidden folder is Error(Fault::io, ...).
void write_file(const std::filesystem::path& file, const std::string& text);

}    // namespace sphonic
