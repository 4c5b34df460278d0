#include <sphonic/plugin/reference.hpp>

#include <stdexcept>

/// A plane wave that fills all space:
///   p = A cos(k . x - c0 |k| t + phase),   u = k / |k| p / (rho0 c0).
struct TravellingWave final : abi::Reference {
    double amplitude = 1, phase = 0;
    Vector wave_number;

    static constexpr auto parameters() {
        using T = TravellingWave;
        return std::array{real("amplitude", &T::amplitude, "Pa", -infinite, infinite, "pressure amplitude A"),
                          vector("wave_number", &T::wave_number, "rad/m", -infinite, infinite,
                                 "k, one component per dimension; the wave travels along it"),
                          real("phase", &T::phase, "rad", -infinite, infinite, "phase at the origin at t = 0")};
    }

    void prepare(const abi::ReferenceScene& scene) override {
        if (wave_number.size != scene.dimension)
            throw std::invalid_argument("wave_number needs one component per dimension");
        k = std::hypot(wave_number.v[0], wave_number.v[1], wave_number.v[2]);
        if (!(k > 0)) throw std::invalid_argument("wave_number has no length: give a vector other than zero");
        medium = scene.medium;
    }

    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        const double impedance = medium.rho0 * medium.c0;
        for (int i = 0; i < points.n; ++i) {
            double angle = phase - medium.c0 * k * t;
            for (int a = 0; a < points.dimension; ++a) angle += wave_number.v[a] * points.x[a][i];
            const double p = amplitude * std::cos(angle);
            if (out.p) out.p[i] = p;
            for (int a = 0; a < points.dimension; ++a)
                if (out.u[a]) out.u[a][i] = wave_number.v[a] / k * p / impedance;
        }
    }

private:
    abi::Medium medium;
    double k = 0;    // |wave_number| [rad/m]
};

SPHONIC_REFERENCE("travelling_wave", TravellingWave, "A plane cosine wave that fills all space, such as a periodic box")
