#pragma once
#include <string>

namespace sphonic {

/// Name of the processor; "unknown" where the system does not tell.
std::string processor();
/// Size of its last level of cache [bytes]; 32 MB where the system does not tell.
double last_cache();

/// Memory that a new process could take without swapping [bytes].
double available_memory();
/// Cores that this process may keep busy: its affinity, and the quota of its control group if there is one.
double available_cores();
/// CPU time of the process, all threads [s].
double cpu_seconds();
/// What it takes to read that clock, by the quickest of some readings: of spans of microseconds it is a good part [s].
double cpu_clock_cost();
/// Monotonic wall clock [s].
double wall_seconds();

}    // namespace sphonic
