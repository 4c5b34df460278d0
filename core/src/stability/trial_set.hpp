#pragma once
#include <vector>

#include <sphonic/stability_trial.hpp>

#include "particle_system.hpp"

namespace sphonic {

/// A set that can begin again and again, and tells its energy.
class StabilityTrial::Set {
public:
    virtual ~Set() = default;
    /// From white noise.
    virtual void start(double dt, unsigned seed) = 0;
    /// From the fastest motion.
    virtual void start_fastest(double dt, unsigned seed) = 0;
    virtual void step() = 0;
    /// In any unit.
    virtual double energy() = 0;
};

/// A particle method's, under the case's integrator.
class StabilityTrial::Particles final : public StabilityTrial::Set {
public:
    explicit Particles(const Case& scene) : scene_(scene), system_(scene) {}
    void start(double dt, unsigned seed) override;
    void start_fastest(double dt, unsigned seed) override;
    void step() override;
    double energy() override { return system_.squares(); }

private:
    const Case& scene_;
    ParticleSystem system_;
    std::vector<double> fastest_;
    double dt_ = 0;
    long index_ = 0;

    void begin(const std::vector<double>& x, double dt);
};

/// Another method's, through its solver; for it the fastest motion is as good as noise.
class StabilityTrial::Other final : public StabilityTrial::Set {
public:
    explicit Other(const Case& scene);
    void start(double dt, unsigned seed) override;
    void start_fastest(double dt, unsigned seed) override { start(dt, seed); }
    void step() override { solver_->step(); }
    double energy() override;

private:
    const Case& scene_;
    std::unique_ptr<abi::Solver> solver_;
};

}    // namespace sphonic
