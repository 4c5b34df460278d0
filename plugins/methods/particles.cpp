#include <sphonic/plugin/method.hpp>

/// The meshfree method itself: kernel, equations and integrator of the case on its particles.
struct Particles final : abi::Method {
    std::unique_ptr<abi::Solver> discretise(const abi::Scene& scene) const override {
        return scene.particles(scene.host);
    }
    bool meshfree() const override { return true; }
};

SPHONIC_METHOD("particles", Particles, "Smoothed particles: kernel, equations and integrator of the case (the default)")
