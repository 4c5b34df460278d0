#pragma once
#include <string>

#include "../staggered/layers.hpp"
#include "../staggered/sources.hpp"
#include "theory.hpp"

namespace kspace {

/// p at whole steps, u half a step behind it. What one medium does to p or u is done to their modes; what media, layers or sources
/// that set values do, in space: two transforms for p then, two more for each component of u.
class Pseudospectral final : public abi::Solver {
public:
    Pseudospectral(const abi::Scene& scene, int threads)
        : scene_(scene), d_(scene.box.dimension), grid_(scene.box, 0, wrapped(scene)), media_(scene, grid_), layers_(scene, grid_, media_),
          sources_(scene, grid_, media_), operators_(grid_, threads), p_(std::size_t(grid_.size)), scratch_(p_), P_(operators_.spectrum.modes()) {
        for (int a = 0; a < d_; ++a) u_[a] = p_, W_[a] = P_;
        limit_ = stable_step(operators_, grid_, media_, grid_.dx / (media_.fastest().c0 * std::sqrt(double(d_))));
    }

    /// Of one medium none is needed; this is where the shortest waves of the grid turn by half a period in a step.
    double dt_limit() const override { return limit_; }
    double time() const override { return double(index_) * dt_; }
    const char* tier() const override { return pressure_in_space_ || velocity_in_space_ ? "kspace" : "kspace_modes"; }
    double neighbours_mean() const override { return double(grid_.points() - 1); }
    double memory_bytes() const override { return 8.0 * double(grid_.size) * (2 + d_) * (media_.uniform() ? 2 : 3) + layers_.bytes(); }
    double energy_bound() const override { return sources_.budget().bound(time()); }

    void start(double dt) override {
        dt_ = dt;
        layers_.start(dt);
        operators_.spectrum.time(media_.fastest().c0, dt);
        sources_.match([&](double omega, const abi::Medium& m) { return tone_response(d_, media_.fastest().c0, m.c0, omega, dt); });
        set_initial_fields();
        sources_.start(p_, u_, dt);
        for (int a = 0; a < d_; ++a) operators_.analyse(a, u_[a], W_[a]);
        operators_.spectrum.forward(p_, P_);
        sources_.budget().start(energy());
    }

    void step() override {
        if (!pressure_in_space_ && !velocity_in_space_ && !sources_.adds()) {
            operators_.both(P_, W_, dt_, media_.of(0));
            ++index_;
            return;
        }
        for (int a = 0; a < d_; ++a) layers_.apply(a, u_[a]);
        kick(dt_);
        if (sources_.adds()) add_velocity();
        for (int a = 0; a < d_; ++a) layers_.apply(a, u_[a]);
        sources_.set_velocity(u_, time() + dt_ / 2);
        for (int a = 0; a < d_ && velocity_in_space_; ++a) operators_.analyse(a, u_[a], W_[a]);
        layers_.apply(-1, p_);
        drift(dt_);
        if (sources_.adds()) add_pressure();
        layers_.apply(-1, p_);
        ++index_;
        sources_.set_pressure(p_, time());
        if (pressure_in_space_) operators_.spectrum.forward(p_, P_);
    }

    /// u half a step behind p.
    double pressure(long point) override { return pressure_in_space_ ? p_[std::size_t(point)] : snapshot().p[point]; }

    abi::Snapshot snapshot() override {
        if (shown_.at.empty()) shown_ = grid_.all(-1);
        abi::Snapshot shot{.points = shown_.points(), .p = p_.data()};
        if (!pressure_in_space_) operators_.synthesise(P_, p_);
        for (int a = 0; a < d_; ++a) {
            shown_u_[a].resize(p_.size());
            operators_.synthesise(a, W_[a], true, shown_u_[a]);
            shot.u[a] = shown_u_[a].data();
        }
        return shot;
    }

    /// 1/2 sum V [p_n^2/K + rho0 u_{n-1/2} . u_{n+1/2}]: what the scheme conserves.
    double energy() override {
        double sum = 0;
        if (!pressure_in_space_) operators_.synthesise(P_, p_);
        for (std::size_t i = 0; i < p_.size(); ++i) sum += p_[i] * p_[i] / media_.bulk_of(i);
        Field u(p_.size());
        for (int a = 0; a < d_; ++a) {
            operators_.synthesise(a, W_[a], false, u);
            operators_.slope(a, P_, scratch_);
            for (std::size_t i = 0; i < u.size(); ++i) sum += u[i] * (media_.density_of(a, i) * u[i] - dt_ * scratch_[i]);
        }
        return 0.5 * grid_.cell() * sum;
    }

private:
    const abi::Scene scene_;
    const int d_;
    const Grid grid_;
    const Media media_;
    staggered::Layers layers_;
    staggered::Sources sources_;
    Operators operators_;
    const bool pressure_in_space_ = !media_.uniform() || layers_.any() || sources_.set_pressure();
    const bool velocity_in_space_ = !media_.uniform() || layers_.any() || sources_.set_velocity();
    double dt_ = 0, limit_ = 0;
    long index_ = 0;
    Field p_, u_[3], scratch_;
    Modes P_, W_[3];
    PointSet shown_;
    Field shown_u_[3];

    /// Every axis repeats; one with layers does so within them.
    static staggered::Ends wrapped(const abi::Scene& scene) {
        for (int a = 0; a < scene.box.dimension; ++a)
            for (const bool upper : {false, true})
                if (!scene.box.periodic[a] && !staggered::absorbs(scene, a, upper))
                    throw std::invalid_argument("the box must repeat or absorb, and its face " + std::string(1, "xyz"[a]) + (upper ? "_max" : "_min") +
                                                " does neither: make the axis periodic, or give both its faces an absorbing_layer");
        return {};
    }

    /// field -= h times a medium's coefficient times what is in scratch_.
    void advance(Field& field, const Field& coefficients, double coefficient, double h) const {
        double* __restrict f = field.data();
        const double *__restrict rate = scratch_.data(), *__restrict c = coefficients.data();
        const std::size_t n = field.size();
        if (media_.uniform())
            for (std::size_t i = 0; i < n; ++i) f[i] -= h * coefficient * rate[i];
        else
            for (std::size_t i = 0; i < n; ++i) f[i] -= h * c[i] * rate[i];
    }
    void kick(double h) {
        for (int a = 0; a < d_; ++a) {
            if (velocity_in_space_) {
                operators_.slope(a, P_, scratch_);
                advance(u_[a], media_.lightness[a], 1 / media_.of(0).rho0, h);
                continue;
            }
            const Spectrum& s = operators_.spectrum;
            const double light = h / media_.of(0).rho0;
            s.for_modes(a, [&](std::size_t m, std::size_t i) { W_[a][m] += light * s.k[a][i] * s.kappa[m] * P_[m]; });
        }
    }
    void drift(double h) {
        if (pressure_in_space_) {
            operators_.divergence(W_, scratch_);
            advance(p_, media_.bulk, Media::modulus(media_.of(0)), h);
            return;
        }
        const Spectrum& s = operators_.spectrum;
        const double stiff = h * Media::modulus(media_.of(0));
        for (int a = 0; a < d_; ++a) s.for_modes(a, [&](std::size_t m, std::size_t i) { P_[m] -= stiff * s.k[a][i] * s.kappa[m] * W_[a][m]; });
    }

    void add_pressure() {
        std::fill(scratch_.begin(), scratch_.end(), 0.0);
        if (!sources_.add_pressure(scratch_, time() + dt_ / 2, dt_)) return;
        const Modes& added = operators_.supply(scratch_);
        if (!pressure_in_space_) {
            for (std::size_t m = 0; m < P_.size(); ++m) P_[m] += added[m];
            return;
        }
        operators_.synthesise(added, scratch_);
        for (std::size_t i = 0; i < p_.size(); ++i) p_[i] += scratch_[i];
    }
    void add_velocity() {
        for (int a = 0; a < d_; ++a) {
            std::fill(scratch_.begin(), scratch_.end(), 0.0);
            if (!sources_.add_velocity(a, scratch_, time(), dt_)) continue;
            const Modes& added = operators_.supply(scratch_);
            if (velocity_in_space_) {
                operators_.synthesise(added, scratch_);
                for (std::size_t i = 0; i < p_.size(); ++i) u_[a][i] += scratch_[i];
                continue;
            }
            Modes turned = added;
            operators_.turn(a, turned);
            for (std::size_t m = 0; m < turned.size(); ++m) W_[a][m] += turned[m];
        }
    }

    /// p and u of t = 0, u then half a step back, to where the scheme keeps it:
    ///   u(-dt/2) = (1 - S)^(1/2) u(0) + dt/(2 rho0) grad p,   S = -(dt/2)^2 1/rho0 grad K div.
    void set_initial_fields() {
        bool moves = false;
        for (int a = 0; a < d_; ++a) {
            PointSet faces = grid_.all(a);
            if (!scene_.initial(scene_.host, "u", a, faces.points(), faces.value.data())) continue;
            faces.put(u_[a]);
            moves = true;
        }
        if (moves) centre(operators_, grid_, media_, dt_, u_);
        PointSet nodes = grid_.all(-1);
        if (scene_.initial(scene_.host, "p", 0, nodes.points(), nodes.value.data())) nodes.put(p_);
        operators_.spectrum.forward(p_, P_);
        for (int a = 0; a < d_; ++a) {
            operators_.slope(a, P_, scratch_);
            for (std::size_t i = 0; i < p_.size(); ++i) u_[a][i] += dt_ / 2 / media_.density_of(a, i) * scratch_[i];
        }
    }
};

}    // namespace kspace
