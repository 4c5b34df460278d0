#include "study_jobs.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sphonic/error.hpp>
#include <sphonic/result_folder.hpp>

#include "interruption.hpp"
#include "study_bar.hpp"

extern char** environ;

namespace sphonic::driver {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Tells points who started them: one that ended before a point could ask to be told is then noticed too.
constexpr const char* launcher_variable = "SPHONIC_LAUNCHER";

/// This program again, for one point of the study; from any folder.
Words command_for(const fs::path& folder, const StudyOptions& options, std::size_t point) {
    Words words{fs::read_symlink("/proc/self/exe").string(), "study", fs::absolute(options.file).string()};
    for (const std::string& one : options.set) words.insert(words.end(), {"--set", one});
    for (const fs::path& path : options.plugin_path) words.insert(words.end(), {"--plugin-path", fs::absolute(path).string()});
    if (options.threads) words.insert(words.end(), {"--threads", std::to_string(options.threads)});
    words.insert(words.end(), {"--out", fs::absolute(folder).string(), "--point", std::to_string(point + 1), "--beside"});
    return words;
}

/// For a shell.
std::string quoted(const Words& words) {
    std::string text;
    for (const std::string& word : words) {
        text += text.empty() ? "'" : " '";
        for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
        text += "'";
    }
    return text;
}

/// Processes of which none outlives it.
class Workers {
public:
    explicit Workers(fs::path log) : log_(std::move(log)) {}
    ~Workers() {
        for (const pid_t id : ids_) kill(id, SIGKILL);    // what they had done is kept
        for (const pid_t id : ids_) waitpid(id, nullptr, 0);
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    std::size_t count() const { return ids_.size(); }

    void start(const Words& command) {
        std::vector<char*> arguments;
        for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, 1, log_.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
        posix_spawn_file_actions_adddup2(&actions, 1, 2);
        pid_t id = 0;
        const int failed = posix_spawn(&id, arguments[0], &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (failed) throw Error(Fault::io, "--jobs", "a process could not be started", "Start fewer");
        ids_.push_back(id);
    }

    /// Whether one has ended since.
    bool reap() {
        for (const pid_t id : ids_) {
            int status = 0;
            if (waitpid(id, &status, WNOHANG) != id) continue;
            std::erase(ids_, id);
            if (status != 0) throw Error(Fault::io, log_.string(), "a point's process failed", "See there for its message");
            return true;
        }
        return false;
    }

private:
    fs::path log_;
    std::vector<pid_t> ids_;
};

}    // namespace

void run_jobs(const Study& study, const fs::path& folder, const StudyOptions& options) {
    using Clock = std::chrono::steady_clock;
    const Interruptible interruptible;
    const auto points = unfinished_points(study, folder);
    setenv(launcher_variable, std::to_string(getpid()).c_str(), 1);
    const auto begin = Clock::now();
    Workers workers(fs::absolute(folder / "jobs.log"));
    StudyBar bar;
    for (std::size_t next = 0, done = 0; done < points.size();) {
        while (next < points.size() && workers.count() < std::size_t(options.jobs)) workers.start(command_for(folder, options, points[next++]));
        interruptible.stop_if_asked(study.file.string(), "with " + std::to_string(points.size() - done) + " points to go; finished runs are kept in " + folder.string() + ", and the same command goes on from there");
        if (!workers.reap()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            continue;
        }
        ++done;
        const double spent = std::chrono::duration<double>(Clock::now() - begin).count();
        bar.show(done, points.size(), spent * double(points.size() - done) / double(done));
    }
}

void end_with_launcher() {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const char* launcher = std::getenv(launcher_variable);
    if (launcher && std::to_string(getppid()) != launcher) raise(SIGKILL);
}

int write_jobs(const Study& study, const fs::path& folder, const StudyOptions& options) {
    const auto points = unfinished_points(study, folder);
    std::string lines;
    for (const std::size_t point : points) lines += quoted(command_for(folder, options, point)) + "\n";
    const fs::path list = fs::absolute(folder / "jobs.txt"), array = fs::absolute(folder / "jobs.slurm");
    write_file(list, lines);
    const std::string at_a_time = std::to_string(options.jobs), last = std::to_string(points.size());
    if (options.launcher == "slurm")
        write_file(array, "#!/bin/bash\n#SBATCH --job-name=" + study.file.stem().string() + "\n#SBATCH --array=1-" + last + (options.jobs > 1 ? "%" + at_a_time : "") +
                              "\n#SBATCH --cpus-per-task=" + std::to_string(study.threads) + "\n#SBATCH --output=" + folder.stem().string() + "-%a.log\n" +
                              "eval \"$(sed -n \"${SLURM_ARRAY_TASK_ID}p\" " + quoted({list.string()}) + ")\"\n");
    Words collect = command_for(folder, options, 0);
    collect.resize(collect.size() - 3);
    collect.push_back("--collect");
    const std::string start = options.launcher == "slurm" ? "sbatch --wait " + quoted({array.string()}) : "parallel" + (options.jobs > 1 ? " --jobs " + at_a_time : std::string()) + " < " + quoted({list.string()});
    std::printf("# %zu of %zu points to run, then their tables\n%s\n%s\n", points.size(), study.points.size(), start.c_str(), quoted(collect).c_str());
    return 0;
}

}    // namespace sphonic::driver
