/// Predicted against measured limits of every kernel that is found, as a table.
#include "../support/stability.hpp"

#include <cstdio>

using namespace sphonic;
using namespace sphonic::testing;

namespace {

constexpr double most_neighbours = 500;

/// Nothing where the kernel does not claim the dimension, reaches no neighbour or too many.
std::optional<StabilityFinding> limit_of(const std::string& name, double h, const std::string& type, int dimension, const std::vector<std::string>& more = {}) {
    std::vector<std::string> set{kernel(name, h), integrator(type)};
    set.insert(set.end(), more.begin(), more.end());
    try {
        const Case c = quiet_box(dimension, side(dimension), set);
        const double reach = c.radius() / c.box.dx, sphere = dimension == 1 ? 2 * reach : dimension == 2 ? testing::pi * reach * reach : 4.19 * std::pow(reach, 3);
        if (sphere > most_neighbours) return std::nullopt;
        return find_stability(c, brief);
    } catch (const Error& e) {
        std::printf("%-16s %d-D h/dx %-5g left out: %s\n", name.c_str(), dimension, h, e.what());
        return std::nullopt;
    }
}

}    // namespace

TEST_CASE("every kernel, width, integrator and dimension has the limit that theory says, to 1 %", "[nightly][bisection]") {
    std::printf("periodic boxes of %d, %d^2 and %d^3 particles; c0 dt/dx, predicted and measured\n", side(1), side(2), side(3));
    double worst = 0;
    int rows = 0;
    for (int dimension = 1; dimension <= 3; ++dimension)
        for (const std::string& name : registry().names("kernel"))
            for (const double h : {1.0, 1.3, 2.0, 3.25})
                for (const char* type : {"leapfrog", "symplectic_euler", "velocity_verlet", "rk4"}) {
                    const auto found = limit_of(name, h, type, dimension);
                    if (!found) break;
                    const double ratio = found->measured.dt / found->predicted.dt, courant = 2.0 * side(dimension);
                    std::printf("%-16s %d-D h/dx %-5g %-17s %8.4f %8.4f  %+.2f %%\n", name.c_str(), dimension, h, type, found->predicted.dt * courant,
                                found->measured.dt * courant, 100 * (ratio - 1));
                    worst = std::max(worst, std::abs(ratio - 1));
                    ++rows;
                    INFO(name << ", h/dx = " << h << ", " << type << " in " << dimension << "-D");
                    CHECK(ratio == Approx(1).margin(0.01));
                }
    std::printf("%d rows, worst %.2f %%\n", rows, 100 * worst);
}

TEST_CASE("every kernel's limit with Monaghan's viscosity is that at half strength, to 1 %", "[nightly][bisection][viscosity]") {
    double worst = 0;
    for (int dimension = 1; dimension <= 2; ++dimension)
        for (const std::string& name : registry().names("kernel"))
            for (const double h : {1.0, 1.3, 2.0, 3.25}) {
                const auto found = limit_of(name, h, "leapfrog", dimension, {R"(/viscosity={"type":"monaghan","alpha":0.06,"beta":0.5})"});
                if (!found) continue;
                const double ratio = found->measured.dt / found->predicted.dt, courant = 2.0 * side(dimension);
                std::printf("%-16s %d-D h/dx %-5g always on %8.4f, half %8.4f, measured %8.4f, none %8.4f  %+.2f %%\n", name.c_str(), dimension, h,
                            *found->always_on * courant, found->predicted.dt * courant, found->measured.dt * courant, *found->inviscid * courant, 100 * (ratio - 1));
                worst = std::max(worst, std::abs(ratio - 1));
                INFO(name << ", h/dx = " << h << " in " << dimension << "-D");
                CHECK(ratio == Approx(1).margin(0.01));
                CHECK(found->measured.dt < *found->inviscid * (1 + found->measured.precision));
                CHECK(found->measured.dt > *found->always_on * (1 - found->measured.precision));
            }
    std::printf("worst %.2f %%\n", 100 * worst);
}
