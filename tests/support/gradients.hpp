#pragma once
/// Gradients of sin(2 pi x) cos(2 pi y) on periodic squares of n x n particles, and their relative L2 errors.
#include "scene.hpp"

namespace sphonic::testing {

/// The set after one small kick du = -dt/rho0 grad p, the gradient by this form.
inline Case kicked(int n, double jitter, const std::string& form) {
    return scene(periodic_box(2, n), {R"(/equations={"p":[{"divergence":"u","form":"difference","times":"-rho0*c0^2"}],"u":[{"gradient":"p","form":")" +
                                          form + R"(","times":"-1/rho0"}]})",
                                      "/kernel/h_over_dx=1.3", "/particles/jitter=" + Json(jitter).dump(), "/initial/p=sin(2*pi*x)*cos(2*pi*y)",
                                      "/integrator={\"type\":\"symplectic_euler\",\"dt\":1e-9,\"unstable\":\"allow\"}", "/until=1e-9"});
}

/// Of gradients g by axis at points of the square.
inline double gradient_error(const abi::Points& points, const std::vector<double> (&g)[2]) {
    double squares = 0, norm = 0;
    for (int i = 0; i < points.n; ++i) {
        const double x = 2 * pi * points.x[0][i], y = 2 * pi * points.x[1][i];
        const double exact[2] = {2 * pi * std::cos(x) * std::cos(y), -2 * pi * std::sin(x) * std::sin(y)};
        for (int a = 0; a < 2; ++a) {
            squares += std::pow(g[a][std::size_t(i)] - exact[a], 2);
            norm += exact[a] * exact[a];
        }
    }
    return std::sqrt(squares / norm);
}

/// By a form, as the solver takes it.
inline double gradient_error(int n, double jitter, const std::string& form) {
    const Case c = kicked(n, jitter, form);
    Simulation simulation(c);
    simulation.run();
    const abi::Snapshot now = simulation.solver().snapshot();
    std::vector<double> g[2];
    for (int a = 0; a < 2; ++a)
        for (int i = 0; i < now.points.n; ++i) g[a].push_back(-now.u[a][i] * c.medium.rho0 / simulation.summary().dt);
    return gradient_error(now.points, g);
}

/// By sums divided along each axis on its own ("diagonal" CSPM), which no form offers.
inline double diagonal_gradient_error(int n, double jitter) {
    const Case c = kicked(n, jitter, "difference");
    Simulation simulation(c);
    const abi::Snapshot now = simulation.solver().snapshot();
    const KernelUse& kernel = c.kernels[0];
    constexpr int window = 4;    // of sites about a displaced one
    std::vector<double> g[2];
    for (int i = 0; i < now.points.n; ++i) {
        double sum[2] = {0, 0}, moment[2] = {0, 0};
        for (int k = 0; k < (2 * window + 1) * (2 * window + 1); ++k) {
            const int column = (i % n + k % (2 * window + 1) - window + n) % n, row = (i / n + k / (2 * window + 1) - window + n) % n, j = row * n + column;
            double r[2], slope = 0;
            for (int a = 0; a < 2; ++a) {
                r[a] = now.points.x[a][i] - now.points.x[a][j];
                r[a] -= std::nearbyint(r[a]);
            }
            const double distance = std::hypot(r[0], r[1]);
            if (j == i || distance >= kernel.radius()) continue;
            kernel.kernel->evaluate(2, 1, &distance, kernel.h, nullptr, &slope);
            for (int a = 0; a < 2; ++a) {
                sum[a] += (now.p[j] - now.p[i]) * slope * r[a];
                moment[a] -= slope * r[a] * r[a];
            }
        }
        for (int a = 0; a < 2; ++a) g[a].push_back(sum[a] / moment[a]);
    }
    return gradient_error(now.points, g);
}

}    // namespace sphonic::testing
