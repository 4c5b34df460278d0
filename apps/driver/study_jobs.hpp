#pragma once
#include <filesystem>

#include <sphonic/study.hpp>

#include "commands.hpp"

namespace sphonic::driver {

/// Each unfinished point as a process of this program, so many at a time. Their messages go to jobs.log.
void run_jobs(const Study& study, const std::filesystem::path& folder, const StudyOptions& options);

/// From now on this process, one point of a study, is killed when what started it ends.
void end_with_launcher();

/// Writes jobs.txt, one command for each unfinished point, and for Slurm jobs.slurm, an array over its lines; says on stdout
/// how to start them and how to collect. The exit code.
int write_jobs(const Study& study, const std::filesystem::path& folder, const StudyOptions& options);

}    // namespace sphonic::driver
