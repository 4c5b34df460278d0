#include <sphonic/plugin/reference.hpp>

#include <stdexcept>

/// A plane tone and what a plane wall throws back, after any transient. The wall is normal to `axis`, at `position` b; with
/// x' = x mirrored at it (x'_a = 2 b - x_a) and R = +1 rigid, -1 soft, 0 absorbing:
///   p = p_in(x) + R p_in(x'),   p_in = A cos(k . x - c0 |k| t + phase),
///   u = k/|k| p_in(x)/(rho0 c0) + R k'/|k| p_in(x')/(rho0 c0),   k' = k with its component along the axis reversed.
/// At right angles in 1-D with phase = pi/2 these are the waves of Zhang, Li and Zhang (2017),
///   p = A [sin(omega t - k x) + R sin(omega t + k x - 2 k b)].
struct ReflectedWave final : abi::Reference {
    double amplitude = 1, phase = 0, position = 0;
    std::string wall = "rigid", axis = "x";
    Vector wave_number;

    static constexpr auto parameters() {
        using R = ReflectedWave;
        return std::array{
            real("amplitude", &R::amplitude, "Pa", -infinite, infinite, "pressure amplitude A of the incident wave"),
            vector("wave_number", &R::wave_number, "rad/m", -infinite, infinite,
                   "k of the incident wave, one component per dimension, towards the wall"),
            real("phase", &R::phase, "rad", -infinite, infinite, "phase of the incident wave at the origin at t = 0"),
            text("wall", &R::wall, "rigid|soft|absorbing", "what comes back: the same, its negative, or nothing"),
            text("axis", &R::axis, "x|y|z", "the wall's normal"),
            real("position", &R::position, "m", -infinite, infinite, "coordinate b of the wall along the axis")};
    }

    void prepare(const abi::ReferenceScene& scene) override {
        if (wave_number.size != scene.dimension)
            throw std::invalid_argument("wave_number needs one component per dimension");
        normal = axis[0] - 'x';
        if (normal >= scene.dimension)
            throw std::invalid_argument("there is no axis " + axis + " in this dimension: choose another");
        if (wave_number.v[normal] == 0)
            throw std::invalid_argument("wave_number has no component along " + axis +
                                        ": the wave never meets the wall");
        k = std::hypot(wave_number.v[0], wave_number.v[1], wave_number.v[2]);
        returned = wall == "rigid" ? 1 : wall == "soft" ? -1 : 0;
        medium = scene.medium;
    }

    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        const double impedance = medium.rho0 * medium.c0;
        for (int i = 0; i < points.n; ++i) {
            double angle = phase - medium.c0 * k * t;
            for (int a = 0; a < points.dimension; ++a) angle += wave_number.v[a] * points.x[a][i];
            const double towards_mirror = 2 * wave_number.v[normal] * (position - points.x[normal][i]);
            const double incident = amplitude * std::cos(angle),
                         reflected = returned * amplitude * std::cos(angle + towards_mirror);
            if (out.p) out.p[i] = incident + reflected;
            for (int a = 0; a < points.dimension; ++a)
                if (out.u[a])
                    out.u[a][i] =
                        wave_number.v[a] / k * (a == normal ? incident - reflected : incident + reflected) / impedance;
        }
    }

private:
    abi::Medium medium;
    int normal = 0;
    double k = 0;           // |wave_number| [rad/m]
    double returned = 0;    // R
};

SPHONIC_REFERENCE("reflected_wave", ReflectedWave, "A plane tone before a rigid, soft or absorbing wall, at any angle")
