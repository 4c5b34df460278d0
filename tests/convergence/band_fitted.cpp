/// Operators fitted to a band: travelling waves in many directions, boxes with walls, other integrators.
#include <sphonic/stability.hpp>

#include "../support/scene.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

constexpr double c0 = 2, rho0 = 1.5;    ///< of periodic_box

/// A wave of `periods` wavelengths m = (m, n, l) across a periodic box of unit length, at no fewer than `per_wavelength` points; its L2
/// error after ten periods, and by how much the energy changed.
struct Outcome {
    double l2, energy;
};
Outcome travel(int dimension, const std::array<int, 3>& m, double per_wavelength, double courant, const std::string& form,
               const std::string& integrator = "leapfrog") {
    const double size = std::sqrt(double(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]));
    std::string phase, vector, u;
    for (int a = 0; a < dimension; ++a) {
        const std::string comma = a ? "," : "", k = Json(2 * pi * m[std::size_t(a)]).dump();
        phase += (a ? "+" : "") + k + "*" + "xyz"[a];
        vector += comma + k;
    }
    for (int a = 0; a < dimension; ++a)
        u += (a ? ",\"" : "\"") + Json(m[std::size_t(a)] / (size * rho0 * c0)).dump() + "*cos(" + phase + ")\"";
    const Case c = scene(periodic_box(dimension, int(std::ceil(per_wavelength * size - 1e-9))),
                         {"/equations={\"p\":[{\"divergence\":\"u\",\"form\":" + form + ",\"times\":\"-rho0*c0^2\"}],\"u\":[{\"gradient\":\"p\",\"form\":" +
                              form + ",\"times\":\"-1/rho0\"}]}",
                          "/initial={\"p\":\"cos(" + phase + ")\",\"u\":[" + u + "]}", "/integrator/type=" + integrator,
                          "/integrator/courant=" + Json(courant).dump(), "/until=" + Json(10 / (size * c0)).dump(),
                          "/reference={\"type\":\"travelling_wave\",\"wave_number\":[" + vector + "]}"});
    const Summary s = run(c);
    return {s.errors->l2, std::abs(s.energy_final / s.energy_initial - 1)};
}

std::string fitted(double per_wavelength, double support) {
    return R"({"type":"band_fitted","points_per_wavelength":)" + Json(per_wavelength).dump() + R"(,"support":)" + Json(support).dump() + "}";
}

}    // namespace

TEST_CASE("fitted operators carry plane waves in all directions of the plane", "[band]") {
    struct Row {
        double per_wavelength, support, courant, most;
    };
    for (const Row row : {Row{6, 3, 0.7, 2e-2}, Row{8, 3, 0.7, 4e-3}, Row{10, 3, 0.7, 1e-3}, Row{6, 4, 0.5, 4e-3}, Row{8, 4, 0.5, 1.2e-3}}) {
        double worst = 0, energy = 0;
        for (int n = 0; n <= 10; ++n) {
            const Outcome o = travel(2, {10, n, 0}, row.per_wavelength, row.courant, fitted(row.per_wavelength, row.support));
            worst = std::max(worst, o.l2), energy = std::max(energy, o.energy);
        }
        INFO(row.per_wavelength << " points per wavelength, support " << row.support << ": worst L2 " << worst);
        CHECK(worst <= row.most);
        CHECK(energy < 1e-12);
    }
}

TEST_CASE("fitted operators carry plane waves in all directions of space", "[band]") {
    for (const auto& [per_wavelength, most] : {std::pair{8.0, 6e-3}, std::pair{10.0, 2e-3}}) {
        double worst = 0, energy = 0;
        for (const std::array<int, 3> m : {std::array{2, 0, 0}, std::array{2, 1, 0}, std::array{2, 2, 0}, std::array{2, 1, 1}, std::array{2, 2, 1}, std::array{2, 2, 2}}) {
            const Outcome o = travel(3, m, per_wavelength, 0.5, fitted(per_wavelength, 3));
            worst = std::max(worst, o.l2), energy = std::max(energy, o.energy);
        }
        INFO(per_wavelength << " points per wavelength: worst L2 " << worst);
        CHECK(worst <= most);
        CHECK(energy < 1e-12);
    }
}

TEST_CASE("a classical kernel is far from that", "[band]") {
    CHECK(travel(2, {10, 0, 0}, 8, 0.7, R"("corrected")").l2 > 0.5);
}

TEST_CASE("other integrators get weights for space alone", "[band]") {
    CHECK(travel(2, {10, 3, 0}, 8, 0.2, fitted(8, 3), "rk4").l2 < 5e-3);
    CHECK(travel(2, {10, 3, 0}, 8, 0.7, fitted(8, 3), "velocity_verlet").l2 < 5e-3);
}

TEST_CASE("the fitted symbol stays within what the integrator bears", "[band]") {
    for (int d = 1; d <= 3; ++d)
        for (const char* integrator : {"leapfrog", "rk4"}) {
            INFO(d << "-D, " << integrator);
            const Case c = scene(periodic_box(d, 12), {"/equations=band_fitted_acoustics", std::string("/integrator/type=") + integrator,
                                                       "/integrator/courant=" + Json(0.5).dump()});
            const StepLimit limit = step_limit(c);
            CHECK(c.whole_step(0.5 / 12 / c0) <= limit.dt);
            CHECK(limit.dt * limit.frequency == Approx(oscillator_limit(c)).epsilon(1e-3));
        }
}

TEST_CASE("walls keep what fitted operators gain, axial modes too", "[band]") {
    for (const auto& [type, wave] : {std::pair{std::string("rigid"), std::string("cos")}, std::pair{std::string("soft"), std::string("sin")}})
        for (const std::array<int, 2> m : {std::array{5, 0}, std::array{5, 2}, std::array{4, 4}}) {
            if (type == "soft" && m[1] == 0) continue;    // no such mode
            const double size = std::hypot(m[0], m[1]), omega = pi * size * c0;
            const int n = int(std::ceil(8 * size / 2));
            const std::string kx = Json(pi * m[0]).dump(), ky = Json(pi * m[1]).dump();
            const Case c = scene(periodic_box(2, n), {"/equations=band_fitted_acoustics", "/integrator/type=leapfrog", "/integrator/courant=0.7",
                                                      "/boundaries=[{\"type\":\"" + type + "\",\"face\":\"all\"}]",
                                                      "/initial={\"p\":\"" + wave + "(" + kx + "*x)*" + wave + "(" + ky + "*y)\"}",
                                                      "/until=" + Json(10 * 2 * pi / omega).dump()});
            INFO(type << " " << m[0] << ", " << m[1]);
            Simulation simulation(c);
            const Profile start = simulation.profile();
            simulation.run();
            const Profile now = simulation.profile();
            double squares = 0, norm = 0;
            for (std::size_t i = 0; i < now.p.size(); ++i) squares += std::pow(now.p[i] - start.p[i], 2), norm += start.p[i] * start.p[i];
            CHECK(std::sqrt(squares / norm) <= 5e-3);
            CHECK(simulation.summary().energy_final == Approx(simulation.summary().energy_initial).epsilon(1e-12));
        }
}

TEST_CASE("fitted operators are refused where their weights do not hold", "[band]") {
    const auto refusal = [](const std::vector<std::string>& set) {
        auto all = set;
        all.push_back("/equations=band_fitted_acoustics");
        scene(periodic_box(2, 12), all);
    };
    using Catch::Matchers::Contains;
    CHECK_THROWS_WITH(refusal({"/boundaries=[]"}), Contains("the face x_min is free"));
    CHECK_THROWS_WITH(refusal({"/boundaries=[]", "/particles/jitter=0.1"}), Contains("the face x_min is free"));
    CHECK_THROWS_WITH(refusal({R"(/medium=[{"c0":2,"rho0":1.5},{"region":"x > 0.5","c0":3,"rho0":15}])", "/particles/jitter=0.1"}), Contains("hold in one medium"));
    CHECK_THROWS_WITH(refusal({"/particles/motion=lagrangian"}), Contains("a set that does not move"));
    CHECK_THROWS_WITH(refusal({"/particles/neighbours=moving"}), Contains("a set that does not move"));
    CHECK_NOTHROW(refusal({}));
}
