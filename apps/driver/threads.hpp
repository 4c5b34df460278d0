#pragma once

namespace sphonic::driver {

/// Makes threads sleep, not spin, while they wait for each other: on a machine that others use too, spinning costs more than
/// the second thread gains. The OpenMP runtime reads its policy before main, so the process starts itself once more, unless
/// the user has chosen a policy.
void wait_passively(char** argv);

}    // namespace sphonic::driver
