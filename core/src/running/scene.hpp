#pragma once
#include <sphonic/case.hpp>

namespace sphonic {

/// A case as methods see it; pointers into the case, which must outlive it.
struct SceneView {
    explicit SceneView(const Case& scene);
    std::vector<abi::PlacedSource> sources;
    abi::Scene scene;
};

}    // namespace sphonic
