#include <sphonic/plugin/reference.hpp>

#include <algorithm>
#include <stdexcept>
#include <vector>

/// A Gaussian pressure let go at rest in free space: p = A exp(-(r/w)^2), u = 0 at t = 0, r the distance from `centre`.
/// With R = r/w, T = c0 t/w, z = 2 R T, E = exp(-R^2 - T^2) and u along the radius (at t < 0, p is even and u is odd):
///   1-D  p = A E cosh z,   rho0 c0 u = A E sinh z                                           (d'Alembert)
///   2-D  p = A/2 int_0^inf exp(-k^2/4) cos(k T) J0(k R) k dk,   rho0 c0 u likewise of sin(k T) J1(k R)
///   3-D  p = A E (cosh z - 2 T^2 i0),   rho0 c0 u = A E (sinh z - 2 T^2 i1)                 (d'Alembert for r p),
///        i0 = sinh z / z,   i1 = (cosh z - i0) / z,   modified spherical Bessel functions: regular at the centre.
/// Landau and Lifshitz (1987), Fluid Mechanics, sections 70-72; Tam and Webb (1993) for 2-D, here by Gauss-Legendre panels
/// with an error below 1e-11 A; its cost per point grows with c0 t/w. In a box it holds until the pulse reaches a face.
struct Pulse final : abi::Reference {
    double amplitude = 1, width = 0;
    Vector centre;

    static constexpr auto parameters() {
        using P = Pulse;
        return std::array{real("amplitude", &P::amplitude, "Pa", -infinite, infinite, "pressure A at the centre at t = 0"),
                          real("width", &P::width, "m", positive, infinite, "w: at this distance the pressure is A/e at t = 0"),
                          vector("centre", &P::centre, "m", -infinite, infinite, "where it starts; the origin if not given")};
    }

    void prepare(const abi::ReferenceScene& scene) override {
        dimension = scene.dimension;
        medium = scene.medium;
        if (centre.size != 0 && centre.size != dimension)
            throw std::invalid_argument("centre needs one component per dimension, or leave it out for the origin");
        if (dimension == 2) panel = gauss_legendre();
    }

    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        const double T = medium.c0 * std::abs(t) / width, u_unit = (t < 0 ? -amplitude : amplitude) / (medium.rho0 * medium.c0);
        const bool any_u = std::any_of(out.u, out.u + dimension, [](const double* u) { return u != nullptr; });
        const std::vector<Node> spectrum = dimension == 2 ? spectrum_at(T) : std::vector<Node>{};
        for (int i = 0; i < points.n; ++i) {
            double d[3] = {0, 0, 0};
            for (int a = 0; a < dimension; ++a) d[a] = points.x[a][i] - centre.v[a];
            const double r = std::hypot(d[0], d[1], d[2]);
            const Wave wave = dimension == 2 ? circular(spectrum, r / width, T, out.p, any_u) : closed(r / width, T);
            if (out.p) out.p[i] = amplitude * wave.p;
            for (int a = 0; a < dimension; ++a)
                if (out.u[a]) out.u[a][i] = r > 0 ? u_unit * wave.u * d[a] / r : 0;
        }
    }

private:
    /// p / A and rho0 c0 u / A.
    struct Wave {
        double p = 0, u = 0;
    };
    /// Of the integral over k: the factors of J0(k R) and J1(k R), weight included.
    struct Node {
        double k, p, u;
    };
    struct Abscissa {
        double x, weight;
    };
    static constexpr double k_end = 10.5;      ///< exp(-k^2/4) = 1e-12: what the integral leaves out
    static constexpr double silence = 6;       ///< widths ahead of c0 t: |p| < A exp(-36) (1 + 12 T) beyond, by Poisson's formula
    static constexpr double panel_angle = 18;  ///< [rad] the most that k (R + T) grows by in a panel: its rule errs by 1e-14
    int dimension = 1;
    abi::Medium medium;
    std::vector<Abscissa> panel;    ///< rule on [-1, 1]

    Wave closed(double R, double T) const {
        const double z = 2 * R * T, outgoing = std::exp(-(R - T) * (R - T));
        const double e_cosh = 0.5 * (outgoing + std::exp(-(R + T) * (R + T))), e_sinh = -0.5 * outgoing * std::expm1(-2 * z);
        if (dimension == 1) return {e_cosh, e_sinh};
        const double e_i0 = z > 0 ? e_sinh / z : e_cosh;
        const double e_i1 = z < 0.5 ? outgoing * std::exp(-z) * i1_series(z) : (e_cosh - e_i0) / z;
        return {e_cosh - 2 * T * T * e_i0, e_sinh - 2 * T * T * e_i1};
    }

    /// i1(z) = z/3 (1 + z^2/10 (1 + z^2/28 (1 + ...))), to the last bit for z < 1/2.
    static double i1_series(double z) {
        double sum = 1;
        for (int n = 6; n >= 1; --n) sum = 1 + sum * z * z / (2 * n * (2 * n + 3));
        return z / 3 * sum;
    }

    static Wave circular(const std::vector<Node>& spectrum, double R, double T, bool want_p, bool want_u) {
        Wave sum;
        if (R > T + silence) return sum;
        if (want_p)
            for (const Node& node : spectrum) sum.p += node.p * ::j0(node.k * R);
        if (want_u)
            for (const Node& node : spectrum) sum.u += node.u * ::j1(node.k * R);
        return sum;
    }

    /// Fine enough for every R that is not silent.
    std::vector<Node> spectrum_at(double T) const {
        const int panels = int(std::ceil(k_end * (2 * T + silence) / panel_angle));
        const double half = 0.5 * k_end / panels;
        std::vector<Node> nodes;
        for (int i = 0; i < panels; ++i)
            for (const Abscissa& at : panel) {
                const double k = (2 * i + 1 + at.x) * half, factor = half * at.weight * 0.5 * k * std::exp(-0.25 * k * k);
                nodes.push_back({k, factor * std::cos(k * T), factor * std::sin(k * T)});
            }
        return nodes;
    }

    /// Roots of the Legendre polynomial P_n by Newton's method; weight 2 / ((1 - x^2) P_n'(x)^2).
    static std::vector<Abscissa> gauss_legendre() {
        constexpr unsigned n = 16;
        std::vector<Abscissa> rule;
        for (unsigned i = 0; i < n; ++i) {
            double x = std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 1;
            for (int pass = 0; pass < 6; ++pass) {
                slope = n * (std::legendre(n - 1, x) - x * std::legendre(n, x)) / (1 - x * x);
                x -= std::legendre(n, x) / slope;
            }
            rule.push_back({x, 2 / ((1 - x * x) * slope * slope)});
        }
        return rule;
    }
};

SPHONIC_REFERENCE("pulse", Pulse, "A Gaussian pressure let go at rest in free space: plane, circular or spherical")
