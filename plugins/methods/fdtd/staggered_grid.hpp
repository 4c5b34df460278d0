#pragma once
#include "../staggered/layers.hpp"
#include "../staggered/sources.hpp"
#include "open_faces.hpp"
#include "theory.hpp"
#include "waves.hpp"

namespace fdtd {

/// p at whole steps, u half a step behind it.
template <int d, int order, bool several>
class StaggeredGrid final : public abi::Solver {
public:
    explicit StaggeredGrid(const abi::Scene& scene)
        : scene_(scene), grid_(scene.box, order / 2, ends_of(scene, order)), media_(scene, grid_), waves_(scene, grid_, media_), open_(scene, grid_, media_),
          layers_(scene, grid_, media_), sources_(scene, grid_, media_) {}

    double dt_limit() const override { return stable_step(grid_, media_, order); }
    double time() const override { return double(index_) * dt_; }
    const char* tier() const override { return "fdtd"; }
    double neighbours_mean() const override { return order * d; }
    double memory_bytes() const override { return waves_.bytes() + layers_.bytes(); }
    double energy_bound() const override { return sources_.budget().bound(time()); }

    void start(double dt) override {
        dt_ = dt;
        layers_.start(dt);
        sources_.match([&](double omega, const abi::Medium& m) { return tone_response(grid_, m, order, omega, dt); });
        set_initial_fields();
        sources_.start(p_, u_, dt);
        waves_.close_velocity();
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
            waves_.close_pressure_across_rows();
    }

    double pressure(long point) override {
        if (shown_.at.empty()) shown_ = staggered::outside_bodies(scene_, grid_.all(-1));
        return p_[shown_.at[std::size_t(point)]];
    }

    /// u half a step behind p, the mean of the two points beside p.
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

    double energy() override { return waves_.energy(dt_); }

private:
    const abi::Scene scene_;
    const Grid grid_;
    const Media media_;
    Waves<d, order, several> waves_;
    OpenFaces open_;
    staggered::Layers layers_;
    staggered::Sources sources_;
    const bool meddled_ = layers_.any() || waves_.around_bodies() || sources_.set_velocity() || sources_.adds();    ///< others than the scheme act between the halves
    const bool touched_ = meddled_ || sources_.set_pressure();
    double dt_ = 0;
    long index_ = 0;
    Field &p_ = waves_.p, (&u_)[3] = waves_.u;
    PointSet shown_;
    std::vector<double> shown_u_[3];

    void both_halves() {
        if constexpr (order == 2)
            if (!meddled_) return waves_.both(dt_);
        damp_velocity();
        waves_.kick(dt_);
        for (int a = 0; a < d; ++a) sources_.add_velocity(a, u_[a], time(), dt_);
        damp_velocity();
        sources_.set_velocity(u_, time() + dt_ / 2);
        if (meddled_) waves_.close_velocity();
        layers_.apply(-1, p_);
        waves_.drift(dt_);
        sources_.add_pressure(p_, time() + dt_ / 2, dt_);
        layers_.apply(-1, p_);
    }
    void damp_velocity() {
        for (int a = 0; a < d; ++a) layers_.apply(a, u_[a]);
    }
    void close_pressure(double since) {
        waves_.close_pressure();
        open_.close(p_, time(), since);
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
        waves_.close_velocity();
        if (moves) waves_.centre_velocity(dt_);
        PointSet nodes = grid_.all(-1);
        if (scene_.initial(scene_.host, "p", 0, nodes.points(), nodes.value.data())) nodes.put(p_);
        close_pressure(0);
        waves_.kick(-dt_ / 2);
    }
};

}    // namespace fdtd
