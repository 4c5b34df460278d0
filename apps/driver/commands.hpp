#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace sphonic::driver {

/// Options that every subcommand shares.
struct Common {
    std::vector<std::filesystem::path> plugin_path;
    bool json = false;    ///< machine-readable result on stdout
};

struct RunOptions : Common {
    std::filesystem::path file;
    std::vector<std::string> set;
    std::filesystem::path out;    ///< empty: runs/NAME, numbered if it exists
    bool force = false;
    int threads = 0;    ///< 0: as many as the set is worth
};

struct StudyOptions : RunOptions {
    int jobs = 1;            ///< points side by side
    std::string launcher;    ///< "parallel" or "slurm": write what starts the points; empty: run them
    int point = 0;           ///< only this one, from 1; 0: all
    bool beside = false;     ///< a point among others that run at the same time
    bool collect = false;    ///< run nothing: tables of what is there
    bool report = false;     ///< one HTML page of it all
};

struct PlanOptions : RunOptions {
    double target = 0;    ///< of the relative L2 error; 0: the case's, else 0.01
    std::string norm = "l2";
    bool free = false;
    double budget_s = 60;
};

struct StabilityOptions : RunOptions {
    std::vector<std::string> vary;    ///< "/pointer=a:b:n", none to two
    bool spectrum = false;
    long long_steps = 0;              ///< of a run for weak growth; 0: none
    long steps = 3000;                ///< of a run that decides whether a step is stable
    double precision = 1e-3;
    int seed = 1;
    bool table = false;               ///< of all kernels' limits, instead of one case's
};

struct DescribeOptions : Common {
    std::string kind, name;    ///< either empty: all of them
    bool markdown = false;
};

struct KernelOptions : Common {
    std::string name;
    std::vector<std::string> compare;
    int dimension = 0;    ///< of the ranking; 0: 2, if the kernel has it
    std::filesystem::path out;    ///< empty: nothing is written
    bool force = false;
};

struct AtlasOptions : Common {
    std::filesystem::path folder = "cases/failures";
    std::vector<std::string> rows;    ///< by name; none: all
    std::filesystem::path out;        ///< empty: runs/atlas, numbered if it exists
    bool force = false;
};

/// Each returns the exit code of a job that was done; errors are thrown.
int run(const RunOptions& options);
int check(const RunOptions& options);
/// `out` is the planned case's file; empty: it goes to stdout.
int plan(const PlanOptions& options);
int study(const StudyOptions& options);
int stability(const StabilityOptions& options);
/// Predicted against measured limits of all kernels, widths, integrators and dimensions, with viscosity, disorder and walls.
int stability_table(const StabilityOptions& options);
int atlas(const AtlasOptions& options);
int list(const Common& options);
int describe(const DescribeOptions& options);
/// `what`: "case" or "study".
int schema(const Common& options, const std::string& what);
int kernel(const KernelOptions& options);
int calibrate(const Common& options);
/// `folder` empty: the kind's own folder in the source tree around the current one.
int new_plugin(const Common& options, const std::string& kind, const std::string& name, const std::filesystem::path& folder);

}    // namespace sphonic::driver
