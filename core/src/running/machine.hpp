#pragma once

namespace sphonic {

/// Memory that a new process could take without swapping [bytes].
double available_memory();
/// CPU time of the calling thread [s].
double thread_cpu_seconds();
/// Monotonic wall clock [s].
double wall_seconds();

}    // namespace sphonic
