#include "threads.hpp"

#include <cstdlib>

#include <unistd.h>

namespace sphonic::driver {

void wait_passively(char** argv) {
    if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT")) return;
    ::setenv("OMP_WAIT_POLICY", "passive", 1);
    ::execv("/proc/self/exe", argv);    // returns only if it fails; the run is then right all the same
}

}    // namespace sphonic::driver
