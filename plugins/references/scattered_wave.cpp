#include <sphonic/plugin/direction.hpp>
#include <sphonic/plugin/reference.hpp>

#include <algorithm>
#include <complex>
#include <stdexcept>
#include <vector>

#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/bessel_prime.hpp>

/// A plane tone and what a circle in the plane throws back, after any transient. With r and phi about `centre`, phi from
/// `direction`, k = omega/c0, a the radius and H_n = J_n + i Y_n:
///   p = A sin(omega t - k r cos phi) + Re(i A S exp(-i omega t)),   u from rho0 du/dt = -grad p,
///   S = -sum_n e_n i^n b_n H_n(kr) cos(n phi),   e_0 = 1, e_n = 2,
///   b_n = J_n(ka)/H_n(ka) where p = 0 on the circle (soft), J_n'(ka)/H_n'(ka) where no velocity crosses it (rigid).
/// p and u are 0 inside. Morse and Ingard (1968), Theoretical Acoustics, chapter 8. The series ends where what it leaves out
/// is below 1e-16 A, some ka + 11 (ka)^(1/3) + 6 terms, and its cost per point grows with their number.
struct ScatteredWave final : abi::Reference {
    double amplitude = 1, omega = 0, radius = 0;
    Vector direction, centre;
    std::string wall = "rigid", field = "total";

    static constexpr auto parameters() {
        using S = ScatteredWave;
        return std::array{
            real("amplitude", &S::amplitude, "Pa", -infinite, infinite, "pressure amplitude A of the incident wave"),
            real("omega", &S::omega, "rad/s", positive, infinite, "angular frequency"),
            vector("direction", &S::direction, "1", -infinite, infinite, "the incident wave's way, normalised; +x if not given"),
            vector("centre", &S::centre, "m", -infinite, infinite,
                   "of the circle, where the incident phase is zero at t = 0; the origin if not given"),
            real("radius", &S::radius, "m", positive, infinite, "of the circle"),
            text("wall", &S::wall, "rigid|soft", "no velocity across the circle, or no pressure on it"),
            text("field", &S::field, "total|scattered", "with the incident wave or without it")};
    }

    void prepare(const abi::ReferenceScene& scene) override {
        if (scene.dimension != 2) throw std::invalid_argument("a circle lies in the plane: it needs two dimensions");
        require_components("centre", centre, 2);
        towards = unit_direction(direction, 2);
        k = omega / scene.medium.c0;
        impedance = scene.medium.rho0 * scene.medium.c0;
        terms.clear();
        const double ka = k * radius;
        Complex turn = {0, amplitude};    // i A i^n
        for (int n = 0;; ++n, turn *= Complex(0, 1)) {
            terms.push_back(-(n > 0 ? 2. : 1.) * turn * returned(n, ka));
            if (n > ka && std::abs(bessel(n, ka)) * std::max(1., n / ka) < left_out) break;
        }
    }

    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        std::vector<Complex> now(terms);
        for (Complex& term : now) term *= std::polar(1., -omega * t);
        for (int i = 0; i < points.n; ++i) {
            const Wave wave = at(t, now, points.x[0][i] - centre.v[0], points.x[1][i] - centre.v[1]);
            if (out.p) out.p[i] = wave.p;
            for (int a = 0; a < 2; ++a)
                if (out.u[a]) out.u[a][i] = wave.u[a];
        }
    }

private:
    using Complex = std::complex<double>;
    /// Boost's functions in double throughout, ten times faster than in long double.
    using Doubles = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
    struct Wave {
        double p = 0, u[2] = {0, 0};
    };
    /// p, and the velocity along r and phi times rho0 c0 [Pa].
    struct Polar {
        double p = 0, r = 0, phi = 0;
    };
    static constexpr double edge = 1e-9;    ///< of the radius: points of the circle may be rounded inwards
    static constexpr double left_out = 1e-17;
    Vector towards;
    double k = 0, impedance = 1;
    std::vector<Complex> terms;    ///< -i A e_n i^n b_n [Pa]

    static double bessel(int n, double z) { return boost::math::cyl_bessel_j(n, z, Doubles()); }
    static double neumann(int n, double z) { return boost::math::cyl_neumann(n, z, Doubles()); }

    /// J_n/H_n of a soft circle, J_n'/H_n' of a rigid one.
    Complex returned(int n, double ka) const {
        const bool soft = wall == "soft";
        const double J = soft ? bessel(n, ka) : boost::math::cyl_bessel_j_prime(n, ka, Doubles());
        return J / Complex(J, soft ? neumann(n, ka) : boost::math::cyl_neumann_prime(n, ka, Doubles()));
    }

    /// At (x, y) from the centre, with the terms as they have turned by t.
    Wave at(double t, const std::vector<Complex>& now, double x, double y) const {
        const double r = std::hypot(x, y);
        if (r < radius * (1 - edge)) return {};
        const double cosine = (towards.v[0] * x + towards.v[1] * y) / r, sine = (towards.v[0] * y - towards.v[1] * x) / r;
        const Polar wave = scattered(now, k * r, cosine, sine);
        const double incident = field == "total" ? amplitude * std::sin(omega * t - k * r * cosine) : 0;
        const double u_r = (wave.r + incident * cosine) / impedance, u_phi = (wave.phi - incident * sine) / impedance;
        return {wave.p + incident, {(u_r * x - u_phi * y) / r, (u_r * y + u_phi * x) / r}};
    }

    /// J_n or Y_n at z, with the neighbours in n.
    struct Cylinder {
        double before, now, next;
        Cylinder(double order_0, double order_1) : before(-order_1), now(order_0), next(order_1) {}
        double slope() const { return 0.5 * (before - next); }
        void ascend(double twice_next_n_over_z) {
            before = now;
            now = next;
            next = twice_next_n_over_z * now - before;
        }
    };

    /// H_n upwards in n: where it is unstable, beyond n = z, only J_n is, and an error of J_n is small beside Y_n.
    static Polar scattered(const std::vector<Complex>& terms, double z, double cosine, double sine) {
        Cylinder J(bessel(0, z), bessel(1, z)), Y(neumann(0, z), neumann(1, z));
        Polar sum;
        double c = 1, s = 0;    // cos(n phi), sin(n phi)
        for (std::size_t n = 0; n < terms.size(); ++n) {
            const double real = terms[n].real(), imag = terms[n].imag();
            sum.p += c * (real * J.now - imag * Y.now);
            sum.r += c * (imag * J.slope() + real * Y.slope());
            sum.phi -= s * double(n) / z * (imag * J.now + real * Y.now);
            J.ascend(2 * double(n + 1) / z);
            Y.ascend(2 * double(n + 1) / z);
            const double turned = c * cosine - s * sine;
            s = s * cosine + c * sine;
            c = turned;
        }
        return sum;
    }
};

SPHONIC_REFERENCE("scattered_wave", ScatteredWave, "A plane tone scattered by a rigid or soft circle in 2-D, after any transient")
