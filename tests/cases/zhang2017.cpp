/// Zhang, Li and Zhang (2017): propagation, the Courant number, and walls.
#include "../support/scene.hpp"
#include "../support/waves.hpp"

#include <filesystem>
#include <map>

#include <sphonic/prediction.hpp>
#include <sphonic/stability.hpp>
#include <sphonic/study.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

constexpr double c0 = 340, omega = 340, k = 1, inflow = -50;    ///< of the published tone
const std::string folder = std::string(SPHONIC_SOURCE_DIR) + "/cases/zhang2017/";

Case zhang(const std::string& name, const std::vector<std::string>& set = {}) {
    return repository_case("zhang2017/" + name, set);
}
std::string number(double x) { return Json(x).dump(); }
std::string spacing(double dx) { return "/particles/dx=" + number(dx); }
std::string velocity(const std::vector<std::string>& components) { return "/initial/u=" + Json(components).dump(); }
std::string courant(double C) { return "/integrator/courant=" + number(C); }

/// The tone on an infinite set: exact at t = 0 everywhere and for all time at the inflow. What started as the initial wave has
/// the set's frequency at the wave number k, what came in later the set's wave number at the frequency omega.
struct Tone {
    double late, short_by;    ///< [rad/s] omega less the set's frequency, [rad/m] the set's wave number less k
    double group;             ///< [m/s]
    double t, start;          ///< end of the run [s], last imposed particle [m]

    Tone(const Case& c, double dt) : t(c.until), start(inflow + 3 * c.box.dx) {
        const double along[3] = {1, 0, 0}, e = 1e-4;
        const auto frequency = [&](double at) { return travelling_mode(c, at, along, dt, 0).omega; };
        late = omega - frequency(k);
        double lower = 0.5 * k, upper = 2 * k;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (lower + upper);
            (frequency(middle) < omega ? lower : upper) = middle;
        }
        short_by = lower - k;
        group = (frequency(k + e) - frequency(k - e)) / (2 * e);
    }
    /// Phase by which it is behind after a way s from the inflow.
    double lag(double s) const { return s < group * t ? short_by * s : late * t; }
    /// What the set should have where the exact wave is A [sin(omega t - k x) + R sin(omega t + k x - 2 k wall)], A = 1 Pa.
    double pressure(double x, double R, double wall) const {
        return std::sin(omega * t - k * x - lag(x - start)) +
               R * std::sin(omega * t + k * x - 2 * k * wall - lag(2 * wall - x - start));
    }
};

/// A run beside theory: L and M of both, and where they differ most, over the reference's region.
struct Beside {
    double L = 0, M = 0, L_theory = 0, M_theory = 0, apart = 0;
    double smooth = 0;    ///< the same, mean of two neighbours along a line
    double across = 0;    ///< differences between particles of one x
    bool diverged = false;
};
Beside beside_theory(const Case& c, double R = 0, double wall = 0) {
    Simulation simulation(c);
    simulation.run();
    if (simulation.summary().diverged) return {.diverged = true};
    const Tone tone(c, simulation.summary().dt);
    const Profile now = simulation.profile();
    Beside b;
    double squares = 0, theory = 0, norm = 0, last = std::nan("");    // none yet
    std::map<long, double> first;                                     // of each x
    for (std::size_t i = 0; i < now.p.size(); ++i) {
        if (!now.in_region[i]) continue;
        const double predicted = tone.pressure(now.x[0][i], R, wall), e = predicted - now.exact[i];
        squares += std::pow(now.p[i] - now.exact[i], 2), theory += e * e, norm += std::pow(now.exact[i], 2);
        b.M_theory = std::max(b.M_theory, std::abs(e));
        b.apart = std::max(b.apart, std::abs(now.p[i] - predicted));
        b.smooth = std::max(b.smooth, 0.5 * std::abs(now.p[i] - predicted + last));
        last = now.p[i] - predicted;
        const double beside = first.emplace(std::lround(now.x[0][i] / c.box.dx), now.p[i]).first->second;
        b.across = std::max(b.across, std::abs(now.p[i] - beside));
    }
    b.L = simulation.summary().errors->l2, b.M = simulation.summary().errors->max;
    b.L_theory = std::sqrt(theory / norm);
    CHECK(b.L == Approx(std::sqrt(squares / norm)).epsilon(1e-9));
    return b;
}

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

double relative_error(const std::vector<std::string>& set) { return run(zhang("propagation", set)).errors->l2; }

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
            for (int i = 0; i < 60; ++i) {
                const double middle = 0.5 * (lower + upper);
                ((excess(middle) > 0) == (excess(lower) > 0) ? lower : upper) = middle;
            }
            return lower;
        };
        const double sound = component(0.1 * kx, 0.8 * top), sawtooth = component(0.8 * top, 0.999 * pi / dx);
        const Waves waves =
            along_x(simulation.probes(), omega, c.until - 4 * pi / omega, {sound, -sound, sawtooth, -sawtooth});
        return std::abs(waves.amplitude[1]) / std::abs(waves.amplitude[0]);
    }
};

/// Slope of log E over log dx by least squares.
double order(const std::vector<double>& dx, const std::vector<double>& error) {
    double x = 0, y = 0, xx = 0, xy = 0;
    const double n = double(dx.size());
    for (std::size_t i = 0; i < dx.size(); ++i) {
        const double a = std::log(dx[i]), b = std::log(error[i]);
        x += a, y += b, xx += a * a, xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

}    // namespace

TEST_CASE("every case of the second paper passes check and every study can be read", "[zhang2017]") {
    int cases = 0, studies = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        if (file.path().extension() != ".json") continue;
        INFO(file.path());
        const Case c = load_case(file.path(), {}, registry());
        const Summary prepared = Simulation(c).summary();
        CHECK(prepared.dt < prepared.dt_limit);
        CHECK(predict(c, prepared).warnings.empty());
        ++cases;
    }
    for (const auto& file : std::filesystem::directory_iterator(folder + "studies")) {
        INFO(file.path());
        CHECK_NOTHROW(load_study(file.path()));
        ++studies;
    }
    CHECK(cases >= 6);
    CHECK(studies >= 3);
}

TEST_CASE("propagation with CSPM has the known errors and the printed rate of two", "[zhang2017]") {
    const std::vector<double> spacings{0.02, 0.04, 0.05, 0.08, 0.10};
    std::vector<double> L, M;
    for (const double dx : spacings) {
        const Beside b = beside_theory(zhang("propagation", {spacing(dx)}));
        INFO("dx = " << dx << " m: L = " << b.L << " (theory " << b.L_theory << "), M/A = " << b.M << " (" << b.M_theory
                     << ")");
        CHECK(b.L == Approx(b.L_theory).epsilon(0.001));
        CHECK(b.M == Approx(b.M_theory).epsilon(0.001));
        L.push_back(b.L), M.push_back(b.M);
    }
    CHECK(L[4] == Approx(0.125).margin(0.003));
    CHECK(M[4] == Approx(0.148).margin(0.003));
    CHECK(L[1] == Approx(0.0200).margin(0.0005));
    CHECK(L[0] ==
          Approx(5.07e-3).epsilon(0.02));    // what the printed rate asks for; the printed 1.5e-3 contradicts it
    CHECK(order(spacings, L) == Approx(2).margin(0.01));
    CHECK(order(spacings, M) == Approx(2).margin(0.01));
}

TEST_CASE("leapfrog errs less the larger its step, as 1 - (C/2)^2", "[zhang2017]") {
    const double slow = relative_error({courant(0.1)});
    for (const double C : {0.5, 1.0, 1.5}) {
        const Beside b = beside_theory(zhang("propagation", {courant(C)}));
        INFO("C = " << C << ": L = " << b.L << " (theory " << b.L_theory << "), " << b.L / slow
                    << " of that at C = 0.1");
        CHECK(b.L / slow == Approx(1 - C * C / 4).margin(0.04));
        CHECK(b.L == Approx(b.L_theory).epsilon(0.01));
    }
}

// Clean: L is the dispersion of set and step, to 5 %. Lost: L is more than ten times that, or the run diverges.
TEST_CASE("Adams-Bashforth is clean at C = 0.25 and lost at 0.32, and at other Courant numbers on another set",
          "[zhang2017]") {
    const auto with = [](double dx, double C) {
        return zhang("propagation", {spacing(dx), courant(C), "/integrator/type=ab2", "/integrator/unstable=allow"});
    };
    const auto over_theory = [&](double dx, double C) {
        const Beside b = beside_theory(with(dx, C));
        return b.diverged ? 1e300 : b.L / b.L_theory;
    };
    CHECK(over_theory(0.04, 0.25) == Approx(1).epsilon(0.05));
    CHECK(over_theory(0.04, 0.32) > 10);
    CHECK(over_theory(0.08, 0.32) == Approx(1).epsilon(0.05));
    CHECK(over_theory(0.08, 0.32 * std::cbrt(2.0)) > 10);

    // what the worst mode grows by over the run is the same at C ~ (dx/(c0 T))^(1/3)
    const auto exponent = [&](double dx, double C) {
        const Case c = with(dx, C);
        const Summary prepared = Simulation(c).summary();
        return double(prepared.steps) * std::log(amplification(c, prepared.dt));
    };
    CHECK(exponent(0.08, 0.28 * std::cbrt(2.0)) == Approx(exponent(0.04, 0.28)).epsilon(0.1));
}

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
