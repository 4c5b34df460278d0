/// Walls: what they keep, what they reflect, and what happens without them.
#include "../support/scene.hpp"
#include "../support/waves.hpp"

#include <sphonic/stability.hpp>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

constexpr double c0 = 340, omega = 340;

std::string corrected_line(double length, double dx, const std::string& rest) {
    return R"({"dimension": 1, "medium": {"c0": 340, "rho0": 1.2},
        "particles": {"type": "lattice", "dx": )" + Json(dx).dump() + R"(, "lower": [0], "upper": [)" + Json(length).dump() + R"(]},
        "kernel": {"type": "cubic_spline", "h_over_dx": 1.2},
        "equations": {"p": [{"divergence": "u", "form": "corrected", "times": "-rho0*c0^2"}],
                      "u": [{"gradient": "p", "form": "corrected", "times": "-1/rho0"}]},
        "integrator": {"type": "leapfrog", "courant": 0.2}, )" + rest + "}";
}

const std::string initial_pulse = R"json("initial": {"p": "exp(-((x-1.3)/0.3)^2)"}, "boundaries": [)json";

std::string wall(const std::string& type, const std::string& face) { return R"({"type": ")" + type + R"(", "face": ")" + face + R"("})"; }

/// What a tone leaves at a wall: amplitudes of what comes back as sound, and as the short wave of the same frequency, F(k') = F(k),
/// which collocated sets have; over that of the tone.
struct Left {
    double sound, sawtooth;
};

/// The wave that the set gives the frequency, between two wave numbers on either side.
double wave_number(const Case& c, double dt, double lower, double upper) {
    const double along[3] = {1, 0, 0};
    return root_between(lower, upper, [&](double k) { return 2 / dt * std::sin(omega * dt / 2) - c0 * dispersion(c, k, along); });
}

Left left_by_mur(double per_wavelength) {
    const double wavelength = 2 * pi * c0 / omega, dx = wavelength / per_wavelength, length = std::round(40 / dx) * dx;
    std::string probes;
    for (double x = length - 2 * wavelength; x < length - dx / 2; x += dx) probes += (probes.empty() ? "[" : ", [") + Json(x).dump() + "]";
    const Case c = scene(corrected_line(length, dx, R"json("sources": [{"type": "exact", "region": "x < 3*h"}],
        "reference": {"type": "travelling_wave", "wave_number": [1], "phase": 1.5707963267948966},
        "initial": {"p": "sin(-x)", "u": ["sin(-x)/(rho0*c0)"]},
        "boundaries": [)json" + wall("absorbing_mur", "x_max") + R"(], "until": 0.2, "output": {"probes": [)" + probes + "]}"));
    Simulation simulation(c);
    simulation.run();
    const double dt = simulation.summary().dt, top = 0.5 * pi / dx;
    const double k = wave_number(c, dt, 0.1 * omega / c0, top * 0.8), other = wave_number(c, dt, top * 0.8, pi / dx * 0.999);
    const Waves waves = along_x(simulation.probes(), omega, c.until - 2 * 2 * pi / omega, {k, -k, other, -other});
    const double tone = std::abs(waves.amplitude[0]);
    return {std::abs(waves.amplitude[1]) / tone, std::hypot(std::abs(waves.amplitude[2]), std::abs(waves.amplitude[3])) / tone};
}

}    // namespace

TEST_CASE("rigid and soft walls keep the energy over a hundred thousand steps", "[wall]") {
    for (const char* type : {"rigid", "soft"})
        for (const char* place : {"on_particles", "half_way"}) {
            INFO(type << " " << place);
            const std::string boundary = std::string(R"({"type": ")") + type + R"(", "face": "x", "wall": ")" + place + R"("})";
            const Summary s = run(scene(corrected_line(4, 0.05, initial_pulse + boundary +
                                                                     R"(], "until": 2.95)")));
            CHECK(s.steps > 100000);
            CHECK(s.energy_final == Approx(s.energy_initial).epsilon(1e-9));
        }
}

TEST_CASE("a wall lies where it says: modes of the box have the wall's length", "[wall]") {
    const auto run_mode = [](const std::string& boundary, const std::string& p) {
        const Case c = scene(corrected_line(4, 0.05, R"("initial": {"p": ")" + p + R"("}, "boundaries": [)" + boundary + R"(], "until": 0.02)"));
        Simulation simulation(c);
        simulation.run();
        const Profile before = Simulation(c).profile(), now = simulation.profile();
        double product = 0, norm = 0, rest = 0;
        for (std::size_t i = 0; i < now.p.size(); ++i) product += before.p[i] * now.p[i], norm += before.p[i] * before.p[i];
        for (std::size_t i = 0; i < now.p.size(); ++i) rest += std::pow(now.p[i] - product / norm * before.p[i], 2);
        return std::sqrt(rest / norm);    // what has left the mode
    };
    const std::string half = R"(, "wall": "half_way"})", on = "}";
    const auto both = [](const std::string& type, const std::string& where) { return R"({"type": ")" + type + R"(", "face": "x")" + where; };
    CHECK(run_mode(both("rigid", on), "cos(3*pi*x/4)") < 1e-10);
    CHECK(run_mode(both("rigid", half), "cos(3*pi*(x+0.025)/4.05)") < 1e-10);
    CHECK(run_mode(both("soft", on), "sin(3*pi*x/4)") < 1e-10);
    CHECK(run_mode(both("soft", half), "sin(3*pi*(x+0.025)/4.05)") < 1e-10);
    CHECK(run_mode(both("rigid", on), "cos(3*pi*(x+0.025)/4.05)") > 1e-3);
}

TEST_CASE("Mur's condition leaves the known residual, as a sawtooth more than as sound", "[wall]") {
    struct Row {
        double per_wavelength, known;
    };
    for (const Row row : {Row{60, 1.9e-4}, Row{30, 1.5e-3}, Row{20, 5.3e-3}, Row{10, 4.9e-2}}) {
        const Left left = left_by_mur(row.per_wavelength);
        INFO(row.per_wavelength << " points per wavelength: sound " << left.sound << ", sawtooth " << left.sawtooth);
        CHECK(left.sawtooth == Approx(row.known).epsilon(0.25));
        CHECK(left.sound < row.known);
    }
}

TEST_CASE("a corrected set that simply ends blows up, and walls cure it", "[wall]") {
    const auto end = [](const std::string& boundaries) {
        return run(scene(corrected_line(4, 0.05, initial_pulse + boundaries + R"(], "until": 2.95)"), {"/kernel/h_over_dx=1.5", "/integrator/unstable=allow"}));
    };
    CHECK(end("").diverged);
    const Summary closed = end(wall("rigid", "x"));
    CHECK_FALSE(closed.diverged);
    CHECK(closed.energy_final == Approx(closed.energy_initial).epsilon(1e-9));
}

TEST_CASE("edges and corners: modes of closed boxes keep their shape and energy", "[wall]") {
    for (int d = 2; d <= 3; ++d)
        for (const auto& [type, p] : {std::pair{"rigid", "cos(2*pi*x)*cos(pi*y)"}, std::pair{"soft", "sin(2*pi*x)*sin(pi*y)"}}) {
            const std::string last = d == 2 ? "" : *type == 'r' ? "*cos(3*pi*z)" : "*sin(3*pi*z)";
            Case c = scene(periodic_box(d, d == 2 ? 24 : 16), {std::string(R"(/boundaries=[{"face":"all","type":")") + type + R"("}])",
                                                              std::string("/initial/p=") + p + last, "/until=0.35", "/kernel/h_over_dx=1.3"});
            INFO(type << " in " << d << "-D");
            Simulation simulation(c);
            const Profile before = simulation.profile();
            simulation.run();
            const Profile now = simulation.profile();
            double product = 0, norm = 0, largest = 0;
            for (std::size_t i = 0; i < now.p.size(); ++i) product += before.p[i] * now.p[i], norm += before.p[i] * before.p[i];
            for (std::size_t i = 0; i < now.p.size(); ++i) largest = std::max(largest, std::abs(now.p[i] - product / norm * before.p[i]));
            CHECK(std::abs(product / norm) > 0.1);
            CHECK(largest < 1e-12);
            CHECK(simulation.summary().energy_final == Approx(simulation.summary().energy_initial).epsilon(1e-12));
        }
}
