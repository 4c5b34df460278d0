#pragma once

namespace sphonic {

const char* version();
/// Commit of the source tree at build time, with "-dirty" if it had changes.
const char* commit();

}    // namespace sphonic
