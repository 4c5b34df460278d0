#include <sphonic/plugin/direction.hpp>
#include <sphonic/plugin/reference.hpp>

#include <stdexcept>

/// A plane Gaussian pulse that meets the plane interface of two media at right angles, in each dimension. With s the distance
/// beyond the interface along `direction`, s0 < 0 that of the incident crest at t = 0, g(x) = exp(-(x/w)^2) and Z = rho0 c0:
///   s <= 0:  p = A [g(s - s0 - c1 t) + R g(s + s0 + c1 t)],   u = A [g(s - s0 - c1 t) - R g(s + s0 + c1 t)]/Z1,
///   s > 0:   p = A T g((c1/c2) s - s0 - c1 t),   u = p/Z2,
///   R = (Z2 - Z1)/(Z2 + Z1),   T = 1 + R = 2 Z2/(Z2 + Z1),   u along `direction`: both are continuous at s = 0.
/// Landau and Lifshitz (1987), Fluid Mechanics, section 66. It holds in all space and at all t, tails included; in a box
/// until the pulse reaches a face. The media are the case's on either side, each one alone as far as the pulse goes.
/// A run starts from it by expressions of the first medium, with the crest six widths or more before the interface: beyond
/// it exp(-36) is left out. For A = 1, w = 0.3, the crest at x = -2 and a first medium that is the first of the list,
///   "initial": { "p": "exp(-((x + 2)/0.3)^2)", "u": ["exp(-((x + 2)/0.3)^2)/(rho0*c0)"] }
/// or at rest, with a source `exact` at the face through which the pulse comes, and `centre` six widths before that.
struct TwoMedia final : abi::Reference {
    double amplitude = 1, width = 0;
    Vector centre, interface, direction;

    static constexpr auto parameters() {
        using T = TwoMedia;
        return std::array{
            real("amplitude", &T::amplitude, "Pa", -infinite, infinite, "pressure A of the incident crest"),
            real("width", &T::width, "m", positive, infinite, "w in the first medium: at this distance from the crest the pressure is A/e"),
            vector("centre", &T::centre, "m", -infinite, infinite,
                   "a point of the incident crest at t = 0, before the interface; the origin if not given"),
            vector("interface", &T::interface, "m", -infinite, infinite, "a point of the interface; the origin if not given"),
            vector("direction", &T::direction, "1", -infinite, infinite,
                   "the way of the incident pulse, across the interface, normalised; +x if not given")};
    }

    bool several_media() const override { return true; }

    void prepare(const abi::ReferenceScene& scene) override {
        require_components("centre", centre, scene.dimension);
        require_components("interface", interface, scene.dimension);
        normal = unit_direction(direction, scene.dimension);
        start = 0;
        for (int a = 0; a < scene.dimension; ++a) start += normal.v[a] * (centre.v[a] - interface.v[a]);
        if (!(start < 0))
            throw std::invalid_argument("centre does not lie before the interface: move it back along direction, or turn direction");
        const abi::Medium &before = side(scene, -1), &beyond = side(scene, 1);
        if (&before == &beyond)
            throw std::invalid_argument("there is one medium on both sides of the interface: give the second one the region beyond it");
        c1 = before.c0, c2 = beyond.c0;
        Z1 = before.rho0 * before.c0, Z2 = beyond.rho0 * beyond.c0;
        R = (Z2 - Z1) / (Z2 + Z1);
    }

    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        for (int i = 0; i < points.n; ++i) {
            double s = 0;
            for (int a = 0; a < points.dimension; ++a) s += normal.v[a] * (points.x[a][i] - interface.v[a]);
            const Wave wave = at(t, s);
            if (out.p) out.p[i] = wave.p;
            for (int a = 0; a < points.dimension; ++a)
                if (out.u[a]) out.u[a][i] = normal.v[a] * wave.u;
        }
    }

private:
    /// p [Pa], and u along `direction` [m/s].
    struct Wave {
        double p, u;
    };
    Vector normal;
    double start = 0;                       // s0 [m]
    double c1 = 1, c2 = 1, Z1 = 1, Z2 = 1;  // [m/s], [kg m^-2 s^-1]
    double R = 0;

    Wave at(double t, double s) const {
        if (s > 0) {
            const double p = amplitude * (1 + R) * pulse(c1 / c2 * s - start - c1 * t);
            return {p, p / Z2};
        }
        const double incident = amplitude * pulse(s - start - c1 * t), reflected = amplitude * R * pulse(s + start + c1 * t);
        return {incident + reflected, (incident - reflected) / Z1};
    }

    double pulse(double x) const { return std::exp(-(x / width) * (x / width)); }

    /// The one medium before (-1) or beyond (+1) the interface: close to it below the centre, and as far off as the centre is,
    /// across the interface and along it.
    const abi::Medium& side(const abi::ReferenceScene& scene, int sign) const {
        const double far = -start, near = 1e-4 * far;
        const auto medium_at = [&](double across, double along, int axis) -> const abi::Medium& {
            double x[3] = {0, 0, 0};
            for (int a = 0; a < scene.dimension; ++a)
                x[a] = centre.v[a] + normal.v[a] * (far + sign * across) + along * ((a == axis) - normal.v[axis] * normal.v[a]);
            return scene.media.at(scene.dimension, x, scene.medium);
        };
        const abi::Medium& found = medium_at(near, 0, 0);
        bool one = &medium_at(far, 0, 0) == &found;
        for (int axis = 0; axis < scene.dimension; ++axis)
            for (const double along : {-far, far}) one = one && &medium_at(near, along, axis) == &found;
        if (!one)
            throw std::invalid_argument(std::string(sign < 0 ? "before" : "beyond") + " the interface lie several media: put interface and "
                                        "direction where the media's regions meet, with no third medium as near as centre");
        return found;
    }
};

SPHONIC_REFERENCE("two_media", TwoMedia, "A plane Gaussian pulse that meets the interface of two media at right angles, and what comes of it")
