/// Sets whose particles pass each other: neighbours change, and with them lists and the order in which particles are visited.
#include <filesystem>
#include <fstream>
#include <numbers>
#include <numeric>
#include <random>

#include "sound.hpp"

using namespace sphonic;
using namespace sphonic::testing;

namespace {

/// Vortices that carry particles some spacings far; `drift` [m/s] of the whole set along both axes.
std::vector<std::string> vortices(const std::string& drift, const std::string& equations) {
    return {"/particles/motion=lagrangian", "/kernel/h_over_dx=1.3", "/equations=" + equations, viscosity, "/until=0.3", "/initial/p=0.1*sin(2*pi*x)*sin(4*pi*y)",
            R"(/initial/u=["0.6*sin(2*pi*x)*cos(2*pi*y)+)" + drift + R"(","-0.6*cos(2*pi*x)*sin(2*pi*y)+)" + drift + "\"]"};
}

Profile final_profile(const std::vector<std::string>& set) {
    const Case c = scene(periodic_box(2, 24), set);
    Simulation simulation(c);
    simulation.run();
    return simulation.profile();
}

/// The points of periodic_box(2, 24), the k-th of them that of number order[k].
std::string write_points(const std::vector<int>& order) {
    const auto file = std::filesystem::temp_directory_path() / ("sphonic_mixing_" + std::to_string(std::random_device{}()) + ".csv");
    std::ofstream out(file);
    out.precision(17);
    for (const int k : order) out << (k % 24) / 24.0 << "," << (k / 24) / 24.0 << "\n";
    return file.string();
}

}    // namespace

TEST_CASE("after mixing every particle has all its neighbours", "[moving]") {
    // the last step's change of pressure is rho0 c0^2 dt sum_j V u_ij . grad_i W_ij over all particles, with the cubic spline
    constexpr double dx = 1.0 / 24, h = 1.3 * dx, dt = 0.002, K = 1.5 * 4;
    auto set = vortices("0.2", "linear_acoustics");
    set.insert(set.end(), {R"(/integrator={"type":"symplectic_euler","dt":0.002})", "/until=0.298"});
    const Profile before = final_profile(set);
    set.push_back("/until=0.3");
    const Profile after = final_profile(set);
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < before.p.size(); ++i) {
        double rate = 0;
        for (std::size_t j = 0; j < before.p.size(); ++j) {
            double r[2], q = 0, u_dot_r = 0;
            for (int a = 0; a < 2; ++a) {
                r[a] = before.x[a][i] - before.x[a][j];
                r[a] -= std::round(r[a]);
                q += r[a] * r[a];
                u_dot_r += ((after.x[a][i] - before.x[a][i]) - (after.x[a][j] - before.x[a][j])) / dt * r[a];
            }
            q = std::sqrt(q) / h;
            const double a = std::max(2 - q, 0.0), b = std::max(1 - q, 0.0), slope = 15 / (7 * std::numbers::pi * h * h * h * h) * (4 * b * b - a * a) / 2;
            if (i != j) rate += K * dx * dx * u_dot_r * slope / q;
        }
        worst = std::max(worst, std::abs(after.p[i] - before.p[i] - dt * rate));
        largest = std::max(largest, std::abs(dt * rate));
    }
    CHECK(worst < 1e-12);
    CHECK(largest > 1e-3);
}

TEST_CASE("a flow that mixes does not notice that all of it drifts", "[moving]") {
    // so its lists become old at other times
    const std::string equations = GENERATE(as<std::string>(), "linear_acoustics", "lagrangian_acoustics");
    const Profile still = final_profile(vortices("0", equations)), drifting = final_profile(vortices("0.5", equations));
    INFO(equations);
    double farthest = 0;
    for (std::size_t i = 0; i < still.p.size(); ++i) farthest = std::max(farthest, std::abs(still.x[0][i] - double(i % 24) / 24));
    CHECK(farthest > 2.0 / 24);
    CHECK(largest_difference(still, drifting) < 1e-10);
}

TEST_CASE("how particles are numbered changes their sound by round-off only", "[moving]") {
    std::vector<int> order(24 * 24);
    std::iota(order.begin(), order.end(), 0);
    const auto numbered = [&] {
        const std::string file = write_points(order);
        auto set = vortices("0", "linear_acoustics");
        set.insert(set.begin(), {"/particles/type=points", "/particles/file=" + file});
        const Profile found = final_profile(set);
        std::filesystem::remove(file);
        return found;
    };
    const Profile rows = numbered();
    std::shuffle(order.begin(), order.end(), std::mt19937(5));
    const Profile mixed = numbered();
    double worst = 0;
    for (std::size_t k = 0; k < order.size(); ++k) worst = std::max(worst, std::abs(mixed.p[k] - rows.p[std::size_t(order[k])]));
    CHECK(worst < 1e-10);
}
