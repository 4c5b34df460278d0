#include <sphonic/plugin/reference.hpp>

#include <stdexcept>
#include <utility>

/// A mode that travels along a straight duct with plane side walls, in 2-D and 3-D. Along the axis, say x, and across it, b:
///   p = A M sin(omega t - kx x),   M = prod_b m(k_b (b - lower_b)),   m = cos between rigid walls, sin between soft ones,
///   k_b = n_b pi/(upper_b - lower_b),   omega = c0 sqrt(kx^2 + sum_b k_b^2),
///   u_x = A kx/(rho0 omega) M sin(omega t - kx x),   u_b = A/(rho0 omega) dM/db cos(omega t - kx x).
/// Crests run at omega/kx, faster than c0 unless all n_b are 0, energy at c0^2 kx/omega. With kx = 0 the mode is at its cut-off
/// and stands across the duct. Morse and Ingard (1968), Theoretical Acoustics, chapter 9.
struct DuctMode final : abi::Reference {
    double amplitude = 1, wave_number = 0;
    std::string axis = "x", walls = "rigid";
    Vector mode, lower, upper;

    static constexpr auto parameters() {
        using D = DuctMode;
        return std::array{
            real("amplitude", &D::amplitude, "Pa", -infinite, infinite, "pressure amplitude A"),
            text("axis", &D::axis, "x|y|z", "along which the duct runs"),
            real("wave_number", &D::wave_number, "rad/m", -infinite, infinite, "kx along the axis; if negative, the mode travels backwards"),
            vector("mode", &D::mode, "1", 0, 1e6, "n, a whole number per dimension: 0 along the axis, between soft walls 1 or more across it"),
            vector("lower", &D::lower, "m", -infinite, infinite, "the corner at the lower walls; its component along the axis is free"),
            vector("upper", &D::upper, "m", -infinite, infinite, "the corner at the upper walls, likewise"),
            text("walls", &D::walls, "rigid|soft", "no velocity across the walls, or no pressure on them")};
    }

    void prepare(const abi::ReferenceScene& scene) override {
        along = axis[0] - 'x';
        if (scene.dimension == 1) throw std::invalid_argument("a duct has side walls: it needs two or three dimensions");
        if (along >= scene.dimension) throw std::invalid_argument("there is no axis " + axis + " in this dimension: choose another");
        for (const auto& [name, given] : {std::pair{"mode", &mode}, {"lower", &lower}, {"upper", &upper}})
            if (given->size != scene.dimension) throw std::invalid_argument(std::string(name) + " needs one component per dimension");
        if (mode.v[along] != 0) throw std::invalid_argument("mode counts half waves across the duct: give 0 along " + axis);
        double squares = wave_number * wave_number;
        for (int a = 0, row = 0; a < scene.dimension; ++a) {
            if (a == along) continue;
            across[row] = {a, wave_number_across(a), lower.v[a]};
            squares += across[row].k * across[row].k;
            ++row;
        }
        if (squares == 0) throw std::invalid_argument("nothing moves: give a wave_number, or a mode, other than zero");
        omega = scene.medium.c0 * std::sqrt(squares);
        rho0 = scene.medium.rho0;
    }

    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        const bool rigid = walls == "rigid";
        const double u_unit = amplitude / (rho0 * omega);
        for (int i = 0; i < points.n; ++i) {
            const double phase = omega * t - wave_number * points.x[along][i], sine = std::sin(phase), cosine = std::cos(phase);
            double m[2] = {1, 1}, slope[2] = {0, 0};    // the factors of M and their derivatives
            for (int row = 0; row + 1 < points.dimension; ++row) {
                const Across& b = across[row];
                const double angle = b.k * (points.x[b.axis][i] - b.lower);
                m[row] = rigid ? std::cos(angle) : std::sin(angle);
                slope[row] = b.k * (rigid ? -std::sin(angle) : std::cos(angle));
            }
            const double M = m[0] * m[1];
            if (out.p) out.p[i] = amplitude * M * sine;
            if (out.u[along]) out.u[along][i] = u_unit * wave_number * M * sine;
            for (int row = 0; row + 1 < points.dimension; ++row)
                if (double* u = out.u[across[row].axis]) u[i] = u_unit * slope[row] * m[1 - row] * cosine;
        }
    }

private:
    /// An axis across the duct: its wave number [rad/m] and its lower wall [m].
    struct Across {
        int axis = 0;
        double k = 0, lower = 0;
    };
    int along = 0;
    Across across[2];
    double omega = 0, rho0 = 1;

    double wave_number_across(int a) const {
        const double n = mode.v[a], height = upper.v[a] - lower.v[a];
        if (n != std::floor(n)) throw std::invalid_argument("mode counts half waves across the duct: give whole numbers");
        if (n == 0 && walls == "soft") throw std::invalid_argument("between soft walls mode 0 is silence: give 1 or more");
        if (!(height > 0)) throw std::invalid_argument("upper does not lie above lower: give the walls in order");
        return n * pi / height;
    }
};

SPHONIC_REFERENCE("duct_mode", DuctMode, "A mode that travels along a straight duct with rigid or soft side walls, in 2-D or 3-D")
