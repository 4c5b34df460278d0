#include "study_runs.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <sphonic/error.hpp>

#include "study_parts.hpp"

namespace fs = std::filesystem;

namespace sphonic {
namespace {

using Status = StudyResult::Status;

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw Error(Fault::io, file.string(), "cannot be read", "Check permissions");
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> run_files(const fs::path& folder) {
    std::vector<fs::path> files;
    if (fs::is_directory(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().filename().string().starts_with("runs") && entry.path().extension() == ".jsonl") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

void add_line(StudyRuns& runs, const std::string& line, const std::string& place) {
    StudyRun run;
    try {
        run = run_from_json(parse_json(line, place));
    } catch (const Json::exception&) {
        throw Error(Fault::io, place, "is no line of a study's run", "Give --force to start over");
    }
    if (run.point >= runs.size()) throw Error(Fault::io, place, "names a point that the study does not have", "Give --force to start over");
    auto& of_point = runs[run.point];
    if (std::ranges::count(of_point, run.repetition, &StudyRun::repetition) == 0) of_point.push_back(std::move(run));
}

[[noreturn]] void cannot_write(const fs::path& file) { throw Error(Fault::io, file.string(), "cannot be written", "Check space and permissions"); }

}    // namespace

StudyRuns read_runs(const Study& study, const fs::path& folder) {
    StudyRuns runs(study.points.size());
    for (const fs::path& file : run_files(folder)) {
        const std::string text = content(file);
        std::size_t begin = 0, number = 1;
        for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
            add_line(runs, text.substr(begin, end - begin), file.string() + ":" + std::to_string(number++));
    }
    for (auto& of_point : runs) std::ranges::sort(of_point, {}, &StudyRun::repetition);
    return runs;
}

bool is_finished(const Study& study, const std::vector<StudyRun>& runs) {
    const auto failed = [](const StudyRun& run) { return run.result.status != Status::done; };
    return int(runs.size()) >= study.repeat || std::ranges::any_of(runs, failed);
}

RunFile::RunFile(fs::path file) : file_(std::move(file)), out_(open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (out_ < 0) cannot_write(file_);
    if (flock(out_, LOCK_EX | LOCK_NB) != 0) {
        close(out_);
        throw Error(Fault::io, file_.string(), "another sphonic is writing it", "Wait for its end, or give another --out");
    }
    const std::string text = content(file_);
    const auto whole = off_t(text.rfind('\n') + 1);    // npos + 1 is 0
    if (ftruncate(out_, whole) != 0 || lseek(out_, whole, SEEK_SET) != whole) {
        close(out_);
        cannot_write(file_);
    }
}

RunFile::~RunFile() { close(out_); }

void RunFile::append(const StudyRun& run) {
    const std::string line = to_json(run).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    for (std::size_t done = 0; done < line.size();) {
        const ssize_t count = write(out_, line.data() + done, line.size() - done);
        if (count <= 0) cannot_write(file_);
        done += std::size_t(count);
    }
}

}    // namespace sphonic
