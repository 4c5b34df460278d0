#include <sphonic/plugin/direction.hpp>
#include <sphonic/plugin/source.hpp>

#include <algorithm>

/// p = amplitude sin(omega t - k . (x - phase_origin)), k = omega/c0 along `direction`; u = direction p / (rho0 c0), with c0 and
/// rho0 at phase_origin. A beginning of full height holds every frequency, and what is long among them leaves a scatterer slowly;
/// with `swell` the wave rises over so many periods behind its front.
/// p (and what it is computed from) is imposed at every step, u at the start only.
struct PlaneWaveSource final : abi::Source {
    double amplitude = 1, omega = 0, swell = 0;
    Vector direction, phase_origin;

    static constexpr auto parameters() {
        using S = PlaneWaveSource;
        return std::array{
            real("amplitude", &S::amplitude, "Pa", -infinite, infinite, "pressure amplitude"),
            real("omega", &S::omega, "rad/s", positive, infinite, "angular frequency"),
            vector("direction", &S::direction, "1", -infinite, infinite,
                   "direction of travel, one component per dimension, normalised; +x if not given"),
            vector("phase_origin", &S::phase_origin, "m", -infinite, infinite,
                   "where the phase is zero at t = 0: put it on the edge of the region; the origin if not given"),
            real("swell", &S::swell, "1", 0, 1000, "periods over which it swells to its full height behind that place")};
    }

    abi::Action action() const override { return {.sets_pressure = true, .sets_velocity_at_start = true}; }
    const abi::PlaneWave* wave() const override { return &emitted; }

    void prepare(const abi::SourceScene& scene) override {
        const int dimension = scene.dimension;
        require_components("phase_origin", phase_origin, dimension);
        const Vector along = unit_direction(direction, dimension);
        emitted.amplitude = amplitude;
        emitted.omega = omega;
        emitted.swell = swell;
        for (int a = 0; a < 3; ++a) {
            emitted.direction[a] = along.v[a];
            emitted.origin[a] = phase_origin.v[a];
        }
        const abi::Medium medium = scene.media.at(dimension, emitted.origin, scene.medium);
        wave_number = omega / medium.c0;
        impedance = medium.rho0 * medium.c0;
    }

    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        for (int begin = 0; begin < points.n; begin += block) {
            const int n = std::min(block, points.n - begin);
            double p[block];
            pressure(t, points, begin, n, p);
            if (out.p) std::copy(p, p + n, out.p + begin);
            for (int a = 0; a < points.dimension; ++a)
                if (out.u[a])
                    for (int i = 0; i < n; ++i) out.u[a][begin + i] = emitted.direction[a] / impedance * p[i];
        }
    }

private:
    static constexpr int block = 256;
    abi::PlaneWave emitted;
    double wave_number = 0, impedance = 1;

    void pressure(double t, const abi::Points& points, int begin, int n, double* __restrict p) const {
        std::fill(p, p + n, omega * t);
        for (int a = 0; a < points.dimension; ++a) {
            const double k = wave_number * emitted.direction[a], origin = emitted.origin[a];
            const double* __restrict x = points.x[a] + begin;
#pragma omp simd
            for (int i = 0; i < n; ++i) p[i] -= k * (x[i] - origin);
        }
        if (swell > 0) {
            for (int i = 0; i < n; ++i) p[i] = emitted.pressure(p[i]);
            return;
        }
        const double A = amplitude;
#pragma omp simd
        for (int i = 0; i < n; ++i) p[i] = A * sin(p[i]);
    }
};

SPHONIC_SOURCE("plane_wave", PlaneWaveSource, "Plane sine wave, imposed on the particles of its region")
