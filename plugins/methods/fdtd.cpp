#include <sphonic/plugin/energy_budget.hpp>
#include <sphonic/plugin/method.hpp>
#include <sphonic/plugin/point_set.hpp>

#include <cmath>
#include <vector>

/// Staggered finite differences in time and space, second order (Yee's scheme for sound):
///   u_a[i+1/2] -= dt/(rho0 dx) (p[i+1] - p[i]),   p[i] -= K dt/dx sum_a (u_a[i+1/2] - u_a[i-1/2]),   K = rho0 c0^2.
/// p lies on the case's lattice, u_a half a spacing beyond it along axis a and half a step behind it in time.
/// Stable to c0 dt/dx = 1/sqrt(d); at that step exact along the diagonal. A free face is a wall half a spacing outside.
namespace {

class StaggeredGrid final : public abi::Solver {
public:
    explicit StaggeredGrid(const abi::Scene& scene) : scene_(scene), d_(scene.box.dimension), budget_(scene.box, scene.medium) {
        for (int a = 0; a < d_; ++a) n_[a] = scene.box.count[a];
        stride_[0] = 1;
        stride_[1] = n_[0] + 2;
        stride_[2] = stride_[1] * (d_ > 1 ? n_[1] + 2 : 1);
        origin_ = 1 + (d_ > 1 ? stride_[1] : 0) + (d_ > 2 ? stride_[2] : 0);
        p_.assign(std::size_t(stride_[2] * (d_ > 2 ? n_[2] + 2 : 1)), 0.0);
        for (int a = 0; a < d_; ++a) u_[a] = p_;
        for (int s = 0; s < scene.source_count; ++s) sources_.push_back(place(scene.sources[s]));
        volume_ = std::pow(scene.box.dx, d_);
        bulk_modulus_ = scene.medium.rho0 * scene.medium.c0 * scene.medium.c0;
    }

    double dt_limit() const override { return scene_.box.dx / (scene_.medium.c0 * std::sqrt(double(d_))); }
    double time() const override { return double(index_) * dt_; }
    const char* tier() const override { return "fdtd"; }
    double neighbours_mean() const override { return 2.0 * d_; }
    double memory_bytes() const override { return 8.0 * double(p_.size()) * (1 + d_); }

    void start(double dt) override {
        dt_ = dt;
        set_initial_fields();
        for (Placed& source : sources_) {
            if (const double omega = source.source->tone()) source.source->match(response(omega));
            if (source.action.sets_pressure) impose_pressure(source, 0);
            for (int a = 0; a < d_; ++a)
                if (source.action.sets_velocity || source.action.sets_velocity_at_start) impose_velocity(source, a, -dt / 2);
        }
        budget_.start(energy());
    }
    double energy_bound() const override { return budget_.bound(time()); }

    void step() override {
        kick();
        for (Placed& source : sources_)
            for (int a = 0; a < d_; ++a) {
                if (source.action.sets_velocity) impose_velocity(source, a, time() + dt_ / 2);
                if (source.action.adds) supply(source.u[a], u_[a], a, source, time(), scene_.medium.rho0);
            }
        const double k = bulk_modulus_ * dt_ / scene_.box.dx;
        for_rows([&](long at) {
            for (int a = 0; a < d_; ++a) {
                double* __restrict p = p_.data() + at;
                const double *__restrict u = u_[a].data() + at, *__restrict behind = u - stride_[a];
                for (long i = 0; i < n_[0]; ++i) p[i] -= k * (u[i] - behind[i]);
            }
        });
        for (Placed& source : sources_)
            if (source.action.adds) supply(source.p, p_, -1, source, time() + dt_ / 2, 1 / bulk_modulus_);
        ++index_;
        for (Placed& source : sources_)
            if (source.action.sets_pressure) impose_pressure(source, time());
    }

    abi::Snapshot snapshot() override {
        fill_points();
        abi::Snapshot shot{.points = {.dimension = d_, .n = int(shown_p_.size())}, .p = shown_p_.data()};
        std::size_t k = 0;
        for_rows([&](long at) {
            for (long i = 0; i < n_[0]; ++i, ++k) {
                shown_p_[k] = p_[std::size_t(at + i)];
                for (int a = 0; a < d_; ++a)
                    shown_u_[a][k] = 0.5 * (u_[a][std::size_t(at + i)] + u_[a][std::size_t(at + i - stride_[a])]);
            }
        });
        for (int a = 0; a < d_; ++a) shot.points.x[a] = x_[a].data(), shot.u[a] = shown_u_[a].data();
        return shot;
    }

    /// 1/2 sum V [p_n^2/K + rho0 u_{n-1/2} . u_{n+1/2}]: what the scheme conserves.
    double energy() override {
        const auto behind = std::vector<std::vector<double>>(u_, u_ + d_);
        kick();
        double sum = 0;
        const auto& m = scene_.medium;
        for_rows([&](long at) {
            for (long i = at; i < at + n_[0]; ++i) {
                const std::size_t k = std::size_t(i);
                sum += p_[k] * p_[k] / bulk_modulus_;
                for (int a = 0; a < d_; ++a) sum += m.rho0 * behind[std::size_t(a)][k] * u_[a][k];
            }
        });
        for (int a = 0; a < d_; ++a) u_[a] = behind[std::size_t(a)];
        return 0.5 * volume_ * sum;
    }

private:
    /// A source on the points of p and on those of each velocity component.
    struct Placed {
        abi::Source* source;
        abi::Action action;
        PointSet p, u[3];
    };

    const abi::Scene scene_;
    int d_;
    long n_[3] = {1, 1, 1}, stride_[3] = {1, 0, 0}, origin_ = 0, index_ = 0;
    double dt_ = 0, volume_ = 0, bulk_modulus_ = 0;
    EnergyBudget budget_;
    std::vector<double> p_, u_[3];
    std::vector<Placed> sources_;
    std::vector<double> x_[3], shown_p_, shown_u_[3];

    template <class Row>
    void for_rows(Row row) const {
        for (long k = 0; k < n_[2]; ++k)
            for (long j = 0; j < n_[1]; ++j) row(origin_ + j * stride_[1] + k * stride_[2]);
    }

    /// u to the next half step. On a free axis the velocity beyond the last point is that of a wall: zero.
    void kick() {
        for (int a = 0; a < d_; ++a)
            if (scene_.box.periodic[a]) wrap(p_, a);
        const double k = dt_ / (scene_.medium.rho0 * scene_.box.dx);
        for_rows([&](long at) {
            for (int a = 0; a < d_; ++a) {
                double* __restrict u = u_[a].data() + at;
                const double *__restrict p = p_.data() + at, *__restrict ahead = p + stride_[a];
                for (long i = 0; i < n_[0]; ++i) u[i] -= k * (ahead[i] - p[i]);
            }
        });
        for (int a = 0; a < d_; ++a) scene_.box.periodic[a] ? wrap(u_[a], a) : close(a);
    }

    /// Calls line(first point of a line along the axis).
    template <class Line>
    void for_lines(int axis, Line line) const {
        const int b = axis == 0 ? 1 : 0, c = axis == 2 ? 1 : 2;
        for (long k = 0; k < n_[c]; ++k)
            for (long j = 0; j < n_[b]; ++j) line(origin_ + j * stride_[b] + k * stride_[c]);
    }
    void wrap(std::vector<double>& f, int axis) const {
        for_lines(axis, [&](long at) {
            const long end = at + (n_[axis] - 1) * stride_[axis];
            f[std::size_t(at - stride_[axis])] = f[std::size_t(end)];
            f[std::size_t(end + stride_[axis])] = f[std::size_t(at)];
        });
    }
    void close(int axis) {
        for_lines(axis, [&](long at) { u_[axis][std::size_t(at + (n_[axis] - 1) * stride_[axis])] = 0; });
    }

    /// The grid's points; those of u_a lie half a spacing further along axis `staggered`.
    PointSet all_points(int staggered) const {
        PointSet all{.dimension = d_, .at = {}, .x = {}, .value = {}};
        const abi::Box& box = scene_.box;
        for (long z = 0; z < n_[2]; ++z)
            for (long y = 0; y < n_[1]; ++y)
                for (long x = 0; x < n_[0]; ++x) {
                    const long site[3] = {x, y, z};
                    all.at.push_back(std::size_t(origin_ + x + y * stride_[1] + z * stride_[2]));
                    for (int a = 0; a < d_; ++a)
                        all.x[a].push_back(box.lower[a] + (double(site[a]) + (a == staggered ? 0.5 : 0)) * box.dx);
                }
        all.value.resize(all.at.size());
        return all;
    }
    Placed place(const abi::PlacedSource& placed) const {
        Placed out{.source = placed.source, .action = placed.source->action(), .p = all_points(-1).members(placed), .u = {}};
        for (int a = 0; a < d_; ++a) out.u[a] = all_points(a).members(placed);
        if (out.p.at.empty()) placed.reaches_nothing(placed.host);
        placed.source->enlist(out.p.points(), std::pow(scene_.box.dx, d_));
        return out;
    }
    void evaluate(const Placed& source, PointSet& set, int axis, double t) const {
        abi::AcousticField out;
        (axis < 0 ? out.p : out.u[axis]) = set.value.data();
        source.source->evaluate(t, set.points(), out);
    }
    void impose_pressure(Placed& source, double t) {
        evaluate(source, source.p, -1, t);
        budget_.imposed(source.p.value, 1 / bulk_modulus_);
        source.p.put(p_);
    }
    void impose_velocity(Placed& source, int axis, double t) {
        evaluate(source, source.u[axis], axis, t);
        budget_.imposed(source.u[axis].value, scene_.medium.rho0);
        source.u[axis].put(u_[axis]);
    }
    /// Adds a rate to a field; `inertia` is what its squares weigh in the energy.
    void supply(PointSet& set, std::vector<double>& field, int axis, const Placed& source, double t, double inertia) {
        evaluate(source, set, axis, t);
        budget_.added(0.5 * volume_ * inertia * set.add(field, dt_), dt_);
    }

    /// sin(omega dt/2) = (c0 dt/dx) sin(k dx/2), mean over axis and diagonals. A tone added half-way through a step has the
    /// gain c0 over the scheme's semi-discrete group velocity, 1 / cos(k dx / (2 sqrt n)) along a diagonal of n axes.
    abi::ToneResponse response(double omega) const {
        const double dx = scene_.box.dx, c0 = scene_.medium.c0;
        abi::ToneResponse mean{0, 0};
        for (int n = 1; n <= d_; ++n) {
            const double root = std::sqrt(double(n)), angle = std::asin(std::sin(0.5 * omega * dt_) * dx / (c0 * dt_ * root));
            const double k = 2 * root * angle / dx;
            mean.wave_number += k / d_;
            mean.gain += std::pow(k * c0 / omega, 0.5 * (d_ - 1)) / std::cos(angle) / d_;
        }
        return mean;
    }
    /// p and u at t = 0; u then goes back by half a step, to where the scheme keeps it.
    void set_initial_fields() {
        PointSet nodes = all_points(-1);
        if (scene_.initial(scene_.host, "p", 0, nodes.points(), nodes.value.data()))
            for (std::size_t i = 0; i < nodes.at.size(); ++i) p_[nodes.at[i]] = nodes.value[i];
        dt_ *= -0.5;
        kick();
        dt_ *= -2;
        for (int a = 0; a < d_; ++a) {
            PointSet faces = all_points(a);
            if (scene_.initial(scene_.host, "u", a, faces.points(), faces.value.data()))
                for (std::size_t i = 0; i < faces.at.size(); ++i) u_[a][faces.at[i]] += faces.value[i];
        }
    }
    void fill_points() {
        if (!shown_p_.empty()) return;
        PointSet nodes = all_points(-1);
        shown_p_.resize(nodes.at.size());
        for (int a = 0; a < d_; ++a) {
            x_[a] = std::move(nodes.x[a]);
            shown_u_[a].resize(shown_p_.size());
        }
    }
};

struct Fdtd final : abi::Method {
    std::unique_ptr<abi::Solver> discretise(const abi::Scene& scene) const override {
        return std::make_unique<StaggeredGrid>(scene);
    }
    bool meshfree() const override { return false; }
};

}    // namespace

SPHONIC_METHOD("fdtd", Fdtd, "Staggered finite differences, second order: the baseline on the same case")
