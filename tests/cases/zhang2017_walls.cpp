/// Zhang, Li and Zhang (2017): the tone before walls and in ducts.
#include "zhang2017.hpp"

using namespace sphonic;
using namespace sphonic::testing;
using namespace sphonic::testing::zhang2017;

namespace {

/// A wall at x = 50 m and what it sends back.
struct Wall {
    const char *name, *boundary;
    double R;
    Case scene(std::vector<std::string> set) const {
        set.push_back(std::string("/boundaries/0/type=") + boundary);
        return zhang(name, set);
    }
};
/// Where nothing comes from the inflow within the run.
const std::string untouched = "/reference/region=x >= 36";
const Wall walls[] = {
    {"soft", "soft", -1}, {"soft", "soft_fdtd", -1}, {"rigid", "rigid", 1}, {"absorbing", "absorbing_mur", 0}};

/// sum V_j dW/dr y_j^2/r_j times `next` to the power of the columns between i and j: how the set differentiates long waves along y
/// that alternate (-1) or not (1) from column to column. Cubic spline, in units of its own.
double along_wall(double h_over_dx, double next) {
    double sum = 0;
    for (int column = -2; column <= 2; ++column)
        for (int row = 1; row <= 2; ++row) {
            const double q = std::hypot(column, row) / h_over_dx, slope = q < 1   ? 2 * q - 1.5 * q * q
                                                                          : q < 2 ? 0.5 * (2 - q) * (2 - q)
                                                                                  : 0;
            sum += slope / q * row * row * std::pow(next, column);
        }
    return sum;
}

/// The tone in a periodic duct at an angle to its end.
struct Oblique {
    double kx, ky, dx, length;

    Case scene() const {
        std::string probes;
        for (double x = length - 4 * pi; x < length - dx / 2; x += dx)
            probes += (probes.empty() ? "[" : ", [") + number(x) + ", 0]";
        const std::string wave = "sin(" + number(-kx) + "*x - " + number(ky) + "*y)", unit = "/(rho0*c0)";
        return zhang("duct_absorbing_2d",
                     {spacing(dx), "/particles/lower=[0, 0]", "/particles/upper=" + Json({length, 2 * pi / ky}).dump(),
                      courant(0.5), "/until=0.2", "/sources/0/region=x < 3*h",
                      "/reference/wave_number=" + Json({kx, ky}).dump(), "/initial/p=" + wave,
                      velocity({wave + "*" + number(kx) + unit, wave + "*" + number(ky) + unit}),
                      R"(/output={"probes": [)" + probes + "]}"});
    }
    /// Amplitude of the sound that comes back over that of the tone.
    double reflected() const {
        const Case c = scene();
        Simulation simulation(c);
        simulation.run();
        const double dt = simulation.summary().dt, top = 0.5 * pi / dx;
        const auto component = [&](double lower, double upper) {    // along x, of what the set has at this frequency
            const auto excess = [&](double x) {
                const double size = std::hypot(x, ky), along[3] = {x / size, ky / size, 0};
                return 2 / dt * std::sin(omega * dt / 2) - c0 * dispersion(c, size, along);
            };
            return root_between(lower, upper, excess);
        };
        const double sound = component(0.1 * kx, 0.8 * top), sawtooth = component(0.8 * top, 0.999 * pi / dx);
        const Waves waves =
            along_x(simulation.probes(), omega, c.until - 4 * pi / omega, {sound, -sound, sawtooth, -sawtooth});
        return std::abs(waves.amplitude[1]) / std::abs(waves.amplitude[0]);
    }
};

}    // namespace

TEST_CASE("before a wall the set has the waves to it and back with its own dispersion, and nothing else",
          "[zhang2017]") {
    for (const Wall& wall : walls)
        for (const double dx : {0.04, 0.1}) {
            const Beside b = beside_theory(wall.scene({spacing(dx), untouched}), wall.R, 50);
            INFO(wall.boundary << ", dx = " << dx << " m: L = " << b.L << ", M/A = " << b.M << " (theory " << b.M_theory
                               << "), from theory " << b.apart);
            CHECK(b.L == Approx(b.L_theory).epsilon(0.005));
            CHECK(b.M == Approx(b.M_theory).epsilon(0.005));
            CHECK(b.apart < (wall.R == 0 ? 1e-2 : 1e-3) * b.M);
        }
}

TEST_CASE("a wall half a spacing beyond the particles sends back a wave of its own place", "[zhang2017]") {
    const double dx = 0.04;
    for (const Wall& wall : walls) {
        if (std::string(wall.boundary) != wall.name) continue;
        const std::string p_back = wall.R > 0 ? " + sin(x - 100 - dx)" : " - sin(x - 100 - dx)";
        const std::string u_back = wall.R > 0 ? " - sin(x - 100 - dx)" : " + sin(x - 100 - dx)";
        const Case c =
            wall.scene({"/boundaries/0/wall=half_way", "/reference/position=" + number(50 + dx / 2), untouched,
                        "/initial/p=sin(-x)" + p_back, velocity({"(sin(-x)" + u_back + ")/(rho0*c0)"})});
        INFO(wall.boundary);
        const double there = beside_theory(c, wall.R, 50 + dx / 2).apart,
                     elsewhere = beside_theory(c, wall.R, 50).apart;
        CHECK(there < 1e-5);
        CHECK(elsewhere > 1e-2);
    }
}

TEST_CASE("the inflow sends back what reaches it wrong as a sawtooth of the same size", "[zhang2017]") {
    const Case c = zhang("soft", {spacing(0.1)});
    const Tone tone(c, Simulation(c).summary().dt);
    const double wrong =
        tone.late * (c.until - (0 - tone.start) / tone.group);    // of the phase, when what is now at x = 0 left
    const Beside b = beside_theory(c, -1, 50);
    CHECK(b.apart == Approx(wrong).epsilon(0.05));
    CHECK(b.smooth < 0.1 * b.apart);
}

TEST_CASE("a duct in the plane carries the tone as a line does, the same at every height", "[zhang2017]") {
    for (const auto& [name, R] : {std::pair{"duct_rigid_2d", 1.0}, std::pair{"duct_absorbing_2d", 0.0}}) {
        const Case c = zhang(name, {untouched});
        const Beside b = beside_theory(c, R, 50);
        INFO(name << ": M/A = " << b.M << " (theory " << b.M_theory << "), from theory " << b.apart << ", across "
                  << b.across);
        CHECK(b.L == Approx(b.L_theory).epsilon(0.01));
        CHECK(b.apart < 0.01 * b.M);
        CHECK(b.across < 1e-11);
    }
}

// For one equation Mur's condition reflects (1 - cos t)/(1 + cos t). Here p and u both obey it, which leaves no sound at all where
// sound and the short wave of the same frequency have the same direction; what does not fit leaves as the short wave. In the plane
// their directions differ, as the short one's derivative along the wall is smaller: the rest is (cos t' - cos t)/(cos t' + cos t) of it.
TEST_CASE("obliquely Mur's condition on p and u sends back less sound than on one of them", "[zhang2017]") {
    for (const double degrees : {45.0, 60.0}) {
        const double angle = degrees * pi / 180, kx = k * std::cos(angle), ky = k * std::sin(angle);
        const double dx = 2 * pi / ky / std::round(20 * pi / ky), length = std::round(40 / dx) * dx;
        const Oblique oblique = {kx, ky, dx, length};
        const double back = oblique.reflected(), one = (1 - std::cos(angle)) / (1 + std::cos(angle));
        const double short_angle = std::asin(along_wall(1.05, -1) / along_wall(1.05, 1) * std::sin(angle));
        const double rest = (std::cos(short_angle) - std::cos(angle)) / (std::cos(short_angle) + std::cos(angle));
        INFO(degrees << " degrees: " << back << " of the wave comes back, " << one << " by one equation, " << one * rest
                     << " by theory");
        CHECK(back < 0.4 * one);
        CHECK(back == Approx(one * rest).margin(0.01));    // to first order in k dx = 0.1
    }
}

// The inflow returns sound as the short wave of the same frequency, as large; Mur's condition returns that as sound, 1/sin(k dx) as large.
TEST_CASE("between an exact inflow and Mur's condition sound grows by 1/sin(k dx) to and fro", "[zhang2017]") {
    const double dx = 0.05, length = 12;
    for (const double per_wavelength : {40.0, 20.0, 10.0}) {
        const double x0 = 50 - length / 2, wave = 2 * pi / (per_wavelength * dx);
        const std::string packet = "exp(-((x - " + number(x0) + ")/2)^2)*cos(" + number(wave) + "*x)";
        const Case c = zhang(
            "absorbing", {spacing(dx), "/particles/lower=[38]", "/sources/0/region=x < 38 + 3*h", "/kernel/h_over_dx=1",
                          "/reference/region=x >= 38", "/reference/amplitude=1e-3", "/initial/p=" + packet,
                          velocity({"-" + packet + "/(rho0*c0)"}), "/output={}", "/until=" + number(2 * length / c0)});
        const Summary s = run(c);
        INFO(per_wavelength << " points per wavelength");
        CHECK(std::sqrt(s.energy_final / s.energy_initial) == Approx(1 / std::sin(wave * dx)).epsilon(0.1));
    }
}

TEST_CASE("a short duct between an exact inflow and Mur's condition blows up, and before a mirror it does not",
          "[zhang2017]") {
    for (const Wall& wall : walls) {
        const Case c =
            wall.scene({"/particles/dx=0.05", "/particles/lower=[46]", "/sources/0/region=x < 46 + 3*h", "/output={}",
                        "/until=0.5", "/reference/amplitude=1e-9", "/initial/p=exp(-((x-48)/0.3)^2)", velocity({"0"})});
        INFO(wall.boundary);
        const Summary s = run(c);
        CHECK(s.diverged == (wall.R == 0));
        if (!s.diverged) CHECK(s.energy_final == Approx(s.energy_initial).epsilon(1e-3));
    }
}
