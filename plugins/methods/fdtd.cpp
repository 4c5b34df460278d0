#include <sphonic/plugin/method.hpp>

#include <cmath>
#include <vector>

/// Staggered finite differences in time and space, second order (Yee's scheme for sound):
///   u_a[i+1/2] -= dt/(rho0 dx) (p[i+1] - p[i]),   p[i] -= K dt/dx sum_a (u_a[i+1/2] - u_a[i-1/2]),   K = rho0 c0^2.
/// p lies on the case's lattice, u_a half a spacing beyond it along axis a and half a step behind it in time.
/// Stable to c0 dt/dx = 1/sqrt(d); at that step exact along the diagonal. A free face is a wall half a spacing outside.
namespace {

class StaggeredGrid final : public abi::Solver {
public:
    explicit StaggeredGrid(const abi::Scene& scene) : scene_(scene), d_(scene.box.dimension) {
        for (int a = 0; a < d_; ++a) n_[a] = scene.box.count[a];
        stride_[0] = 1;
        stride_[1] = n_[0] + 2;
        stride_[2] = stride_[1] * (d_ > 1 ? n_[1] + 2 : 1);
        origin_ = 1 + (d_ > 1 ? stride_[1] : 0) + (d_ > 2 ? stride_[2] : 0);
        p_.assign(std::size_t(stride_[2] * (d_ > 2 ? n_[2] + 2 : 1)), 0.0);
        for (int a = 0; a < d_; ++a) u_[a] = p_;
        for (int s = 0; s < scene.source_count; ++s) sources_.push_back(place(scene.sources[s]));
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
            impose_pressure(source, 0);
            for (int a = 0; a < d_; ++a) impose_velocity(source, a, -dt / 2);
        }
    }

    void step() override {
        kick();
        const double k = scene_.medium.rho0 * scene_.medium.c0 * scene_.medium.c0 * dt_ / scene_.box.dx;
        for_rows([&](long at) {
            for (int a = 0; a < d_; ++a) {
                double* __restrict p = p_.data() + at;
                const double *__restrict u = u_[a].data() + at, *__restrict behind = u - stride_[a];
                for (long i = 0; i < n_[0]; ++i) p[i] -= k * (u[i] - behind[i]);
            }
        });
        ++index_;
        for (Placed& source : sources_)
            if (source.imposed.pressure_each_step) impose_pressure(source, time());
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
                sum += p_[k] * p_[k] / (m.rho0 * m.c0 * m.c0);
                for (int a = 0; a < d_; ++a) sum += m.rho0 * behind[std::size_t(a)][k] * u_[a][k];
            }
        });
        for (int a = 0; a < d_; ++a) u_[a] = behind[std::size_t(a)];
        return 0.5 * std::pow(scene_.box.dx, d_) * sum;
    }

private:
    struct Grid {
        std::vector<std::size_t> at;
        std::vector<double> x[3], value;
    };
    /// A source on the points of p and on those of each velocity component.
    struct Placed {
        const abi::Source* source;
        abi::Imposed imposed;
        Grid p, u[3];
    };

    const abi::Scene scene_;
    int d_;
    long n_[3] = {1, 1, 1}, stride_[3] = {1, 0, 0}, origin_ = 0, index_ = 0;
    double dt_ = 0;
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
    Grid all_points(int staggered) const {
        Grid all;
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
    Grid members(const abi::PlacedSource& placed, int staggered) const {
        const Grid all = all_points(staggered);
        Grid kept;
        std::vector<unsigned char> inside(all.at.size());
        placed.inside(placed.region, points(all), inside.data());
        for (std::size_t i = 0; i < all.at.size(); ++i) {
            if (!inside[i]) continue;
            kept.at.push_back(all.at[i]);
            for (int a = 0; a < d_; ++a) kept.x[a].push_back(all.x[a][i]);
        }
        kept.value.resize(kept.at.size());
        return kept;
    }
    Placed place(const abi::PlacedSource& placed) const {
        Placed out{.source = placed.source, .imposed = placed.source->imposed(), .p = members(placed, -1), .u = {}};
        for (int a = 0; a < d_; ++a) out.u[a] = members(placed, a);
        return out;
    }
    abi::Points points(const Grid& grid) const {
        abi::Points list{.dimension = d_, .n = int(grid.at.size())};
        for (int a = 0; a < d_; ++a) list.x[a] = grid.x[a].data();
        return list;
    }
    void impose_pressure(Placed& source, double t) {
        source.source->evaluate(t, points(source.p), {.p = source.p.value.data()});
        for (std::size_t i = 0; i < source.p.at.size(); ++i) p_[source.p.at[i]] = source.p.value[i];
    }
    void impose_velocity(Placed& source, int axis, double t) {
        Grid& grid = source.u[axis];
        abi::AcousticField out;
        out.u[axis] = grid.value.data();
        source.source->evaluate(t, points(grid), out);
        for (std::size_t i = 0; i < grid.at.size(); ++i) u_[axis][grid.at[i]] = grid.value[i];
    }
    /// p and u at t = 0; u then goes back by half a step, to where the scheme keeps it.
    void set_initial_fields() {
        Grid nodes = all_points(-1);
        if (scene_.initial(scene_.host, "p", 0, points(nodes), nodes.value.data()))
            for (std::size_t i = 0; i < nodes.at.size(); ++i) p_[nodes.at[i]] = nodes.value[i];
        dt_ *= -0.5;
        kick();
        dt_ *= -2;
        for (int a = 0; a < d_; ++a) {
            Grid faces = all_points(a);
            if (scene_.initial(scene_.host, "u", a, points(faces), faces.value.data()))
                for (std::size_t i = 0; i < faces.at.size(); ++i) u_[a][faces.at[i]] += faces.value[i];
        }
    }
    void fill_points() {
        if (!shown_p_.empty()) return;
        Grid nodes = all_points(-1);
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
