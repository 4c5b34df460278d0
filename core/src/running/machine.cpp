#include "machine.hpp"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>

#include <sched.h>

namespace sphonic {
namespace {

double clock_seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

}    // namespace

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
    return "unknown";
}

double last_cache() {
    double kilobytes = 0;
    for (int level = 0; level < 8; ++level) {
        std::ifstream file("/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(level) + "/size");
        double size = 0;
        if (file >> size) kilobytes = std::max(kilobytes, size);    // "32768K"
    }
    return kilobytes > 0 ? 1024 * kilobytes : 32e6;
}

double available_memory() {
    std::ifstream file("/proc/meminfo");
    std::string key, unit;
    for (double kilobytes = 0; file >> key >> kilobytes; std::getline(file, unit))
        if (key == "MemAvailable:") return kilobytes * 1024;
    return std::numeric_limits<double>::infinity();
}

double available_cores() {
    cpu_set_t allowed;
    double cores = sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : 1;
    std::ifstream quota("/sys/fs/cgroup/cpu.max");
    double share = 0, period = 0;
    if (quota >> share >> period) cores = std::min(cores, std::max(1.0, share / period));    // "max" instead of a number: no quota
    return cores;
}

double cpu_seconds() { return clock_seconds(CLOCK_PROCESS_CPUTIME_ID); }

double cpu_clock_cost() {
    static const double cost = [] {
        double least = 1e-3;
        for (int i = 0; i < 50; ++i) {
            const double begin = cpu_seconds();
            least = std::min(least, cpu_seconds() - begin);
        }
        return least;
    }();
    return cost;
}

double wall_seconds() { return clock_seconds(CLOCK_MONOTONIC); }

}    // namespace sphonic
