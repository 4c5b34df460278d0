#pragma once
#include "bodies.hpp"
#include "scheme.hpp"
#include "walls.hpp"

namespace fdtd {

/// p and u between walls and around bodies, and what the scheme does with them: the halves of a step.
template <int d, int order, bool several>
class Waves {
public:
    Field p, u[3];

    Waves(const abi::Scene& scene, const Grid& grid, const Media& media)
        : p(std::size_t(grid.size)), grid_(grid), media_(media), walls_(scene, grid), bodies_(scene, grid, order) {
        for (int a = 0; a < d; ++a) u[a] = p;
    }

    bool around_bodies() const { return bodies_.any(); }
    double bytes() const { return 8.0 * double(grid_.size) * (1 + d) * (several ? 2 : 1) + bodies_.bytes(); }

    /// A step of order 2 in one pass, where nothing acts between its halves.
    void both(double dt) {
        double* const to[3] = {u[0].data(), u[1].data(), u[2].data()};
        Scheme::both(grid_, media_, p.data(), to, dt, [&](long row) { walls_.close_row(p.data() + row); });
    }
    /// u by h. At order 2 the images of p beyond a wall make those of u.
    void kick(double h) {
        double* const to[3] = {u[0].data(), u[1].data(), u[2].data()};
        Scheme::kick(grid_, media_, p.data(), to, h, [&](long row) {
            if constexpr (order > 2) walls_.close_velocity_row(to[0] + row);
        });
        if (bodies_.any()) bodies_.mend_velocity(p, u, h / (grid_.dx * media_.of(0).rho0));
        for (int a = bodies_.any() ? 0 : 1; a < d && order > 2; ++a) walls_.close_velocity(u, a);
    }
    /// p by h, with its ghosts along x where there are no bodies; u's are as they should be.
    void drift(double h) {
        const double* const from[3] = {u[0].data(), u[1].data(), u[2].data()};
        Scheme::drift(grid_, media_, p.data(), from, h, [&](long row) { walls_.close_row(p.data() + row); });
        if (bodies_.any()) bodies_.mend_pressure(u, p.data(), h / grid_.dx * Media::modulus(media_.of(0)));
    }
    void close_velocity() {
        bodies_.close_velocity(u);
        walls_.close_velocity(u);
    }
    void close_pressure() {
        bodies_.close_pressure(p);
        walls_.close_pressure(p);
    }
    /// After a step in one pass, which has closed the ends of rows.
    void close_pressure_across_rows() {
        for (int a = 1; a < d; ++a) walls_.close_pressure(p, a);
    }

    /// 1/2 sum V [p_n^2/K + rho0 u_{n-1/2} . u_{n+1/2}], with half of what lies on a wall or on a soft body: what the scheme conserves.
    double energy(double dt) {
        const std::vector<Field> behind(u, u + d);
        kick(dt);
        double sum = 0;
        for (int c = -1; c < d; ++c)
            for_weights(c, [&](std::size_t at, double weight) {
                if (bodies_.any() && c >= 0 && bodies_.halved(c, at)) weight *= 0.5;
                if (c < 0)
                    sum += weight * p[at] * p[at] / media_.bulk_of(at);
                else
                    sum += weight * media_.density_of(c, at) * behind[std::size_t(c)][at] * u[c][at];
            });
        for (int a = 0; a < d; ++a) u[a] = behind[std::size_t(a)];
        return 0.5 * grid_.cell() * sum;
    }

    /// u = (1 - S)^(1/2) u by its power series, S = -(dt/2)^2 1/rho0 grad K div; p is zero before and after. Waves of few points at a step near the limit have S near
    /// one, where it takes thousands of terms: as many as are cheap, until they no longer count.
    void centre_velocity(double dt) {
        constexpr double counts = 1e-15, cheap = 1e8;
        const double most = std::max(24.0, cheap / double(p.size()));
        Field sum[3] = {u[0], u[1], u[2]};
        double coefficient = 1;
        double largest = 1, added = 1;
        for (int k = 1; k <= most && added > counts * largest; ++k) {
            std::fill(p.begin(), p.end(), 0.0);
            drift(dt / 2);
            walls_.close_pressure(p);
            for (Field& one : u) std::fill(one.begin(), one.end(), 0.0);
            kick(-dt / 2);    // u = S u
            coefficient *= (k - 1.5) / k;
            largest = added = 0;
            for (int a = 0; a < d; ++a)
                for (std::size_t i = 0; i < sum[a].size(); ++i) {
                    added = std::max(added, std::abs(coefficient * u[a][i]));
                    largest = std::max(largest, std::abs(sum[a][i] += coefficient * u[a][i]));
                }
        }
        for (int a = 0; a < d; ++a) u[a] = sum[a];
        std::fill(p.begin(), p.end(), 0.0);
    }

private:
    const Grid& grid_;
    const Media& media_;
    const Walls walls_;
    const Bodies bodies_;

    using Scheme = Halves<d, order, several>;

    /// Calls use(place, weight) for the points of p, or of u along an axis.
    template <class Use>
    void for_weights(int axis, Use use) const {
        long begin[3] = {0, 0, 0};
        if (axis >= 0) begin[axis] = -1;
        for (long k = begin[2]; k < grid_.n[2]; ++k)
            for (long j = begin[1]; j < grid_.n[1]; ++j)
                for (long i = begin[0]; i < grid_.n[0]; ++i) {
                    const long site[3] = {i, j, k};
                    double weight = 1;
                    for (int a = 0; a < d; ++a) weight *= walls_.weight(a, site[a], a == axis);
                    if (weight > 0) use(std::size_t(grid_.origin + i + j * grid_.stride[1] + k * grid_.stride[2]), weight);
                }
    }
};

}    // namespace fdtd
