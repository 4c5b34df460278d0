#include <sphonic/plugin/reference.hpp>

#include <algorithm>
#include <stdexcept>
#include <vector>

/// Plane waves that set out at t = 0 into a medium at rest:
///   p = sum of A swelling sin(phase) where phase = omega t - k . (x - origin) >= 0, and nothing beyond a front (phase < 0).
struct PlaneWaveFront final : abi::Reference {
    void prepare(const abi::ReferenceScene& scene) override {
        if (scene.wave_count == 0)
            throw std::invalid_argument("there is no wave to follow: add a plane_wave source, or remove the reference");
        waves.assign(scene.waves, scene.waves + scene.wave_count);
        medium = scene.medium;
    }
    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        if (out.p) std::fill(out.p, out.p + points.n, 0.0);
        for (double* u : out.u)
            if (u) std::fill(u, u + points.n, 0.0);
        for (const abi::PlaneWave& wave : waves)
            for (int i = 0; i < points.n; ++i) add(wave, t, points, i, out);
    }

private:
    std::vector<abi::PlaneWave> waves;
    abi::Medium medium;

    void add(const abi::PlaneWave& wave, double t, const abi::Points& points, int i,
             const abi::AcousticField& out) const {
        double phase = wave.omega * t;
        for (int a = 0; a < points.dimension; ++a)
            phase -= wave.omega / medium.c0 * wave.direction[a] * (points.x[a][i] - wave.origin[a]);
        if (phase < 0) return;
        const double p = wave.pressure(phase);
        if (out.p) out.p[i] += p;
        for (int a = 0; a < points.dimension; ++a)
            if (out.u[a]) out.u[a][i] += wave.direction[a] * p / (medium.rho0 * medium.c0);
    }
};

SPHONIC_REFERENCE("plane_wave_front", PlaneWaveFront, "The sources' plane waves, cut at their fronts")
