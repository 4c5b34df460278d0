#include <sphonic/plugin/reference.hpp>

#include <stdexcept>

/// The mode of a rigid or periodic box, omega = c0 |k|:
///   p = A cos(omega t) prod_a cos(k_a x_a),
///   u_a = A k_a / (rho0 omega) sin(omega t) sin(k_a x_a) prod_{b != a} cos(k_b x_b).
/// p vanishes everywhere at odd quarter periods: an error relative to it means nothing there, so end a run elsewhere
/// or give `scale`.
struct StandingWave final : abi::Reference {
    double amplitude = 1;
    Vector wave_number;

    static constexpr auto parameters() {
        using S = StandingWave;
        return std::array{
            real("amplitude", &S::amplitude, "Pa", -infinite, infinite, "pressure amplitude A"),
            vector("wave_number", &S::wave_number, "rad/m", -infinite, infinite,
                   "k, one component per dimension; n pi / length for mode n of a box from zero to length")};
    }

    void prepare(const abi::ReferenceScene& scene) override {
        if (wave_number.size != scene.dimension)
            throw std::invalid_argument("wave_number needs one component per dimension");
        const double k = std::hypot(wave_number.v[0], wave_number.v[1], wave_number.v[2]);
        if (!(k > 0)) throw std::invalid_argument("wave_number has no length: give a vector other than zero");
        omega = scene.medium.c0 * k;
        rho0 = scene.medium.rho0;
    }

    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        const double p_now = amplitude * std::cos(omega * t), u_now = amplitude / (rho0 * omega) * std::sin(omega * t);
        for (int i = 0; i < points.n; ++i) {
            if (out.p) out.p[i] = p_now * product(points, i, none);
            for (int a = 0; a < points.dimension; ++a)
                if (out.u[a]) out.u[a][i] = u_now * wave_number.v[a] * product(points, i, a);
        }
    }

private:
    static constexpr int none = -1;
    double omega = 0, rho0 = 1;

    /// Product of cos(k_a x_a) over the axes, with a sine on axis `odd`.
    double product(const abi::Points& points, int i, int odd) const {
        double value = 1;
        for (int a = 0; a < points.dimension; ++a) {
            const double angle = wave_number.v[a] * points.x[a][i];
            value *= a == odd ? std::sin(angle) : std::cos(angle);
        }
        return value;
    }
};

SPHONIC_REFERENCE("standing_wave", StandingWave,
                  "The mode of a rigid or periodic box; its pressure vanishes at odd quarter periods")
