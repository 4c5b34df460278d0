#pragma once
#include <sphonic/kernel_card.hpp>
#include <sphonic/plugin/abi/kernel.hpp>

namespace sphonic {

/// In the dimensions that the kernel claims.
std::vector<KernelLaw> kernel_laws(const abi::Kernel& kernel);
KernelTransform kernel_transform(const abi::Kernel& kernel, int dimension);

}    // namespace sphonic
