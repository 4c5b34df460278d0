#pragma once
#include "../staggered/layers.hpp"
#include "../staggered/sources.hpp"
#include "bodies.hpp"
#include "open_faces.hpp"
#include "theory.hpp"
#include "walls.hpp"

namespace fdtd {

/// p at whole steps, u half a step behind it.
template <int d, int order, bool several>
class StaggeredGrid final : public abi::Solver {
public:
    explicit StaggeredGrid(const abi::Scene& scene)
        : scene_(scene), grid_(scene.box, order / 2, ends_of(scene, order)), media_(scene, grid_), walls_(scene, grid_), bodies_(scene, grid_, order), open_(scene, grid_, media_),
          layers_(scene, grid_, media_), sources_(scene, grid_, media_), p_(std::size_t(grid_.size)) {
        for (int a = 0; a < d; ++a) u_[a] = p_;
    }

    double dt_limit() const override { return stable_step(grid_, media_, order); }
    double time() const override { return double(index_) * dt_; }
    const char* tier() const override { return "fdtd"; }
    double neighbours_mean() const override { return order * d; }
    double memory_bytes() const override { return 8.0 * double(grid_.size) * (1 + d) * (several ? 2 : 1) + layers_.bytes() + bodies_.bytes(); }
    double energy_bound() const override { return sources_.budget().bound(time()); }

    void start(double dt) override {
        dt_ = dt;
        layers_.start(dt);
        sources_.match([&](double omega, const abi::Medium& m) { return tone_response(grid_, m, order, omega, dt); });
        set_initial_fields();
        sources_.start(p_, u_, dt);
        close_velocity();
        close_pressure(0);
        sources_.budget().start(energy());
    }

    void step() override {
        both_halves();
        ++index_;
        sources_.set_pressure(p_, time());
        if (touched_ || open_.any())
            close_pressure(dt_);
        else
            for (int a = 1; a < d; ++a) walls_.close_pressure(p_, a);
    }

    /// u half a step behind p, the mean of the two points beside p.
    double pressure(long point) override {
        if (shown_.at.empty()) shown_ = staggered::outside_bodies(scene_, grid_.all(-1));
        return p_[shown_.at[std::size_t(point)]];
    }

    abi::Snapshot snapshot() override {
        if (shown_.at.empty()) shown_ = staggered::outside_bodies(scene_, grid_.all(-1));
        abi::Snapshot shot{.points = shown_.points(), .p = shown_.value.data()};
        for (std::size_t i = 0; i < shown_.at.size(); ++i) shown_.value[i] = p_[shown_.at[i]];
        for (int a = 0; a < d; ++a) {
            shown_u_[a].resize(shown_.at.size());
            for (std::size_t i = 0; i < shown_.at.size(); ++i)
                shown_u_[a][i] = 0.5 * (u_[a][shown_.at[i]] + u_[a][shown_.at[i] - std::size_t(grid_.stride[a])]);
            shot.u[a] = shown_u_[a].data();
        }
        return shot;
    }

    /// 1/2 sum V [p_n^2/K + rho0 u_{n-1/2} . u_{n+1/2}], with half of what lies on a wall or on a soft body: what the scheme conserves.
    double energy() override {
        const std::vector<Field> behind(u_, u_ + d);
        kick(dt_);
        double sum = 0;
        for (int c = -1; c < d; ++c)
            for_weights(c, [&](std::size_t at, double weight) {
                if (bodies_.any() && c >= 0 && bodies_.halved(c, at)) weight *= 0.5;
                if (c < 0)
                    sum += weight * p_[at] * p_[at] / media_.bulk_of(at);
                else
                    sum += weight * media_.density_of(c, at) * behind[std::size_t(c)][at] * u_[c][at];
            });
        for (int a = 0; a < d; ++a) u_[a] = behind[std::size_t(a)];
        return 0.5 * grid_.cell() * sum;
    }

private:
    const abi::Scene scene_;
    const Grid grid_;
    const Media media_;
    const Walls walls_;
    const Bodies bodies_;
    OpenFaces open_;
    staggered::Layers layers_;
    staggered::Sources sources_;
    const bool meddled_ = layers_.any() || bodies_.any() || sources_.set_velocity() || sources_.adds();    ///< others than the scheme act between the halves
    const bool touched_ = meddled_ || sources_.set_pressure();
    double dt_ = 0;
    long index_ = 0;
    Field p_, u_[3];
    PointSet shown_;
    std::vector<double> shown_u_[3];

    using Scheme = Halves<d, order, several>;

    void both_halves() {
        if constexpr (order == 2)
            if (!meddled_) {
                double* const u[3] = {u_[0].data(), u_[1].data(), u_[2].data()};
                return Scheme::both(grid_, media_, p_.data(), u, dt_, [&](long row) { walls_.close_row(p_.data() + row); });
            }
        damp_velocity();
        kick(dt_);
        for (int a = 0; a < d; ++a) sources_.add_velocity(a, u_[a], time(), dt_);
        damp_velocity();
        sources_.set_velocity(u_, time() + dt_ / 2);
        if (meddled_) close_velocity();
        layers_.apply(-1, p_);
        drift(p_.data(), dt_);
        sources_.add_pressure(p_, time() + dt_ / 2, dt_);
        layers_.apply(-1, p_);
    }
    void damp_velocity() {
        for (int a = 0; a < d; ++a) layers_.apply(a, u_[a]);
    }
    void close_velocity() {
        bodies_.close_velocity(u_);
        walls_.close_velocity(u_);
    }
    /// u by h. At order 2 the images of p beyond a wall make those of u.
    void kick(double h) {
        double* const u[3] = {u_[0].data(), u_[1].data(), u_[2].data()};
        Scheme::kick(grid_, media_, p_.data(), u, h, [&](long row) {
            if constexpr (order > 2) walls_.close_velocity_row(u[0] + row);
        });
        if (bodies_.any()) bodies_.mend_velocity(p_, u_, h / (grid_.dx * media_.of(0).rho0));
        for (int a = bodies_.any() ? 0 : 1; a < d && order > 2; ++a) walls_.close_velocity(u_, a);
    }
    /// p by h, with its ghosts along x where there are no bodies; u's are as they should be.
    void drift(double* p, double h) const {
        const double* const u[3] = {u_[0].data(), u_[1].data(), u_[2].data()};
        Scheme::drift(grid_, media_, p, u, h, [&](long row) { walls_.close_row(p + row); });
        if (bodies_.any()) bodies_.mend_pressure(u_, p, h / grid_.dx * Media::modulus(media_.of(0)));
    }
    void close_pressure(double since) {
        bodies_.close_pressure(p_);
        walls_.close_pressure(p_);
        open_.close(p_, time(), since);
    }

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

    /// p and u of t = 0, u then half a step back, to where the scheme keeps it:
    ///   u(-dt/2) = (1 - S)^(1/2) u(0) + dt/(2 rho0) grad p,   S = -(dt/2)^2 1/rho0 grad K div,
    /// in which S is sin^2(omega dt/2) of each wave of the grid, so that one which sets out to one side only does so.
    void set_initial_fields() {
        bool moves = false;
        for (int a = 0; a < d; ++a) {
            PointSet faces = grid_.all(a);
            if (!scene_.initial(scene_.host, "u", a, faces.points(), faces.value.data())) continue;
            faces.put(u_[a]);
            moves = true;
        }
        close_velocity();
        if (moves) centre_velocity();
        PointSet nodes = grid_.all(-1);
        if (scene_.initial(scene_.host, "p", 0, nodes.points(), nodes.value.data())) nodes.put(p_);
        close_pressure(0);
        kick(-dt_ / 2);
    }
    /// u = (1 - S)^(1/2) u by its power series; p is zero before and after. Waves of few points at a step near the limit have S near
    /// one, where it takes thousands of terms: as many as are cheap, until they no longer count.
    void centre_velocity() {
        constexpr double counts = 1e-15, cheap = 1e8;
        const double most = std::max(24.0, cheap / double(p_.size()));
        Field sum[3] = {u_[0], u_[1], u_[2]};
        double coefficient = 1;
        double largest = 1, added = 1;
        for (int k = 1; k <= most && added > counts * largest; ++k) {
            std::fill(p_.begin(), p_.end(), 0.0);
            drift(p_.data(), dt_ / 2);
            walls_.close_pressure(p_);
            for (auto& u : u_) std::fill(u.begin(), u.end(), 0.0);
            kick(-dt_ / 2);    // u = S u
            coefficient *= (k - 1.5) / k;
            largest = added = 0;
            for (int a = 0; a < d; ++a)
                for (std::size_t i = 0; i < sum[a].size(); ++i) {
                    added = std::max(added, std::abs(coefficient * u_[a][i]));
                    largest = std::max(largest, std::abs(sum[a][i] += coefficient * u_[a][i]));
                }
        }
        for (int a = 0; a < d; ++a) u_[a] = sum[a];
        std::fill(p_.begin(), p_.end(), 0.0);
    }
};

}    // namespace fdtd
