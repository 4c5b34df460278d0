#pragma once
/// A plane wave on a circle of radius 1 at the origin, against the exact series.
#include <complex>
#include <vector>

#include "scene.hpp"
#include "waves.hpp"

namespace sphonic::testing {

/// The scattered part of a steady plane wave exp(i (omega t - k x)):  -sum_n e_n (-i)^n a_n H_n(kr) cos(n angle), H of the second kind,
/// a_n = J_n'(k)/H_n'(k) at a rigid wall, J_n(k)/H_n(k) at a soft one; e_0 = 1, else 2 (Morse and Ingard 1968, section 8.1).
inline Complex scattered_by_circle(double k, bool soft, double x, double y) {
    const auto J = [](int n, double s) { return n < 0 ? -std::cyl_bessel_j(1.0, s) : std::cyl_bessel_j(double(n), s); };
    const auto H = [&](int n, double s) { return Complex(J(n, s), n < 0 ? std::cyl_neumann(1.0, s) : -std::cyl_neumann(double(n), s)); };
    const double r = std::hypot(x, y), angle = std::atan2(y, x);
    Complex sum = 0, turn = 1;    // (-i)^n
    for (int n = 0; n < int(k) + 12; ++n, turn *= Complex(0, -1)) {
        const Complex a = soft ? J(n, k) / H(n, k) : (J(n - 1, k) - J(n + 1, k)) / (H(n - 1, k) - H(n + 1, k));
        sum -= (n ? 2.0 : 1.0) * turn * a * H(n, k * r) * std::cos(n * angle);
    }
    return sum;
}

/// A case of it: n spacings to the radius, a wave front that has passed the circle long enough for the sound to be steady, and boxes
/// so large that nothing has come back from their ends.
struct Scattering {
    double k;    ///< [1/m]; c0 = 1
    int n;
    bool soft = false;
    std::string kernel = R"({"type":"cubic_spline","h_over_dx":1})";
    double courant = 1.8;
    double steady = 9.5;    ///< how long after the front at the circle's centre to end

    std::string text(bool with_circle) const {
        const double dx = 1.0 / n, layer = 3 * pi / k, begin = -steady + 1.5, side = steady - 1.5;
        std::string probes = "[0,0]";
        for (int i = 0; i < 48; ++i) probes += ",[" + Json(2 * std::cos(i * pi / 24)).dump() + "," + Json(2 * std::sin(i * pi / 24)).dump() + "]";
        const auto spacings = [&](double x) { return Json(std::round(x * n) * dx).dump(); };
        return R"({"dimension": 2, "medium": {"c0": 1, "rho0": 1},
            "particles": {"type": "lattice", "dx": )" + Json(dx).dump() + R"(, "lower": [)" + spacings(begin - 0.5) + ", " + spacings(-side) + R"(], "upper": [)" +
               spacings(3 + layer) + ", " + spacings(side) + R"(]}, "kernel": )" + kernel + R"(, "equations": "corrected_acoustics",
            "boundaries": [{"type": "periodic", "face": "y"}, {"type": "absorbing_layer", "face": "x_max", "attenuation": 50, "thickness": )" + Json(layer).dump() + R"(}],
            "sources": [{"type": "plane_wave", "region": "x < )" + Json(begin).dump() + R"(", "omega": )" + Json(k).dump() + R"(, "phase_origin": [)" + Json(begin).dump() +
               R"(, 0]}],)" + (with_circle ? std::string(R"("obstacles": [{"type": "circle", "radius": 1, "wall": ")") + (soft ? "soft" : "rigid") + "\"}]," : "") +
               R"("integrator": {"type": "leapfrog", "courant": )" + Json(courant).dump() + R"(}, "until": )" + Json(steady - begin).dump() +
               R"(, "output": {"every": )" + Json(2 * pi / k / 24).dump() + R"(, "probes": [)" + probes + "]}}";
    }

    /// Relative L2 error of the scattered pressure on a ring of radius 2: with the circle and without, over the last period. The incident
    /// wave is the one that comes to the circle's centre.
    double error() const {
        const Case with = scene(text(true)), without = scene(text(false));
        Simulation scattering(with), incident(without);
        scattering.run();
        incident.run();
        const auto there = demodulated(scattering.probes(), k, with.until - 2 * pi / k), undisturbed = demodulated(incident.probes(), k, with.until - 2 * pi / k);
        const auto& ring = scattering.probes().read_at;
        const Complex wave = undisturbed[0] * std::polar(1.0, k * incident.probes().read_at[0][0]);
        double squares = 0, norm = 0;
        for (std::size_t i = 1; i < ring.size(); ++i) {
            const Complex exact = wave * scattered_by_circle(k, soft, ring[i][0], ring[i][1]);
            squares += std::norm(there[i] - undisturbed[i] - exact);
            norm += std::norm(exact);
        }
        return std::sqrt(squares / norm);
    }
};

}    // namespace sphonic::testing
