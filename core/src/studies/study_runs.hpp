#pragma once
/// The runs of a study: lines of a file that outlives the program.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <sphonic/study.hpp>

namespace sphonic {

/// One repetition of a point. Its `why` and `summary` are those of a result.
struct StudyRun {
    std::size_t point = 0;
    int repetition = 1;
    double took_s = 0;             ///< wall time with the set-up
    bool side_by_side = false;
    StudyResult result;
};

Json to_json(const StudyRun& run);
StudyRun run_from_json(const Json& line);

/// Runs by point, in the order of their repetitions.
using StudyRuns = std::vector<std::vector<StudyRun>>;

/// Of all files runs*.jsonl in a folder. A last line without an end was torn by a kill and is passed over; of two lines for one
/// repetition the first counts.
StudyRuns read_runs(const Study& study, const std::filesystem::path& folder);

/// A point needs no more runs.
bool is_finished(const Study& study, const std::vector<StudyRun>& runs);

/// The median run, the quartiles of all, and doubts about them.
StudyResult merged(const std::vector<StudyRun>& runs);

/// Adds lines to a file, each whole; a torn last line is cut off first. Two writers at a time are refused.
class RunFile {
public:
    explicit RunFile(std::filesystem::path file);
    ~RunFile();
    RunFile(const RunFile&) = delete;
    RunFile& operator=(const RunFile&) = delete;
    void append(const StudyRun& run);

private:
    std::filesystem::path file_;
    int out_;
};

}    // namespace sphonic
