/// One small working plugin of each kind. NAME stands for the plugin's name, Model for its struct.
#include "scaffolds.hpp"

#include <cctype>
#include <string_view>

namespace sphonic::driver {
namespace {

struct Text {
    std::string_view kind, set, source;
    std::string_view scene = "cases/li2015/propagation.json";    ///< where it can be tried
};

constexpr Text kernel{"kernel", "/kernel/type=NAME", R"(#include <sphonic/plugin/kernel.hpp>

/// Wendland (1995) C2 with support R h:  w(q) = (1 - q/R)^4 (1 + 4 q/R),  0 <= q < R.
struct Model {
    double radius = 2;

    static constexpr auto parameters() {
        return std::array{real("radius", &Model::radius, "1", 1, 10, "radius R of the support in units of h")};
    }

    double support() const { return radius; }
    double sigma(int dim) const {
        const double R = radius;
        return dim == 1 ? 3 / (2 * R) : dim == 2 ? 7 / (pi * R * R) : 21 / (2 * pi * R * R * R);
    }
    double w(double q) const {
        const double s = plus(1 - q / radius);
        return s * s * s * s * (5 - 4 * s);
    }
    double dw(double q) const {
        const double s = plus(1 - q / radius);
        return -20 * q / (radius * radius) * s * s * s;
    }
    static abi::KernelProperties properties() {
        abi::KernelProperties claims;
        claims.positive_definite = true;
        return claims;
    }
};

SPHONIC_KERNEL("NAME", Model, dimensions(1, 2, 3), "Wendland C2 with support R h")
)"};

constexpr Text viscosity{"viscosity", R"(/viscosity={"type":"NAME"})", R"(#include <sphonic/plugin/viscosity.hpp>

/// Linear in the speed of approach, zero for receding pairs:
///   Pi_ij = -alpha c_ij phi_ij / rho_ij,   phi_ij = h_ij min(u_ij . r_ij, 0) / (r_ij^2 + (0.1 h_ij)^2)
struct Model {
    double alpha = 0.1;

    static constexpr auto parameters() {
        return std::array{real("alpha", &Model::alpha, "1", 0, 10, "coefficient of the damping")};
    }

    struct Pair {
        double linear;    ///< of u_ij . r_ij
    };
    Pair prepare(double r2, double h, double c, double rho) const { return {-alpha * c * h / ((r2 + 0.01 * h * h) * rho)}; }
    double operator()(const Pair& pair, double u_dot_r) const { return pair.linear * std::min(u_dot_r, 0.0); }
};

SPHONIC_VISCOSITY("NAME", Model, "Linear artificial viscosity for approaching pairs")
)"};

constexpr Text dissipation{"dissipation", R"(/dissipation={"type":"NAME"})", R"(#include <sphonic/plugin/dissipation.hpp>

/// a_ij = c V_j |dW/dr| exp(-(r/R h)^2): near pairs more than far ones.
struct Model {
    double radius = 2;

    static constexpr auto parameters() {
        return std::array{real("radius", &Model::radius, "1", 0.5, infinite, "radius R of the coupling in units of h")};
    }

    double operator()(const DampedPair& ij) const {
        const double q = ij.r / (radius * ij.h);
        return ij.c * ij.V * std::abs(ij.dW) * exp(-q * q);
    }
    double strength(double disorder) const { return std::min(3.5 * disorder, 10.0); }
};

SPHONIC_DISSIPATION("NAME", Model, "Fourth-order dissipation of near pairs")
)"};

constexpr Text form{
    "form",
    R"(/equations={"p":[{"divergence":"u","form":"NAME","times":"-rho0*c0^2"}],"u":[{"gradient":"p","form":"sum","times":"-1/rho0"}]})",
    R"(#include <sphonic/plugin/form.hpp>

/// sum_j V_j (f_j - f_i) grad W_ij
struct Model {
    static constexpr bool uniform = true;
    static constexpr double own(PairSide, PairSide) { return -1; }
    static constexpr double other(PairSide, PairSide) { return 1; }
};

SPHONIC_FORM("NAME", Model, "f_j - f_i: exact for constants")
)"};

constexpr Text state{
    "state",
    R"(/equations={"drho":[{"divergence":"u","form":"difference","times":"-rho0"}],"p":{"state":"NAME","of":"drho"},"u":[{"gradient":"p","form":"sum","times":"-1/rho0"}]})",
    R"(#include <sphonic/plugin/state.hpp>

/// p = stiffness c0^2 drho
struct Model final : abi::State {
    double stiffness = 1;

    static constexpr auto parameters() {
        return std::array{real("stiffness", &Model::stiffness, "1", positive, infinite, "factor of the medium's c0^2")};
    }

    void evaluate(const abi::Medium& m, int n, const double* drho, double* p) const override {
        for (int i = 0; i < n; ++i) p[i] = derivative(m, 0) * drho[i];
    }
    void invert(const abi::Medium& m, int n, const double* p, double* drho) const override {
        for (int i = 0; i < n; ++i) drho[i] = p[i] / derivative(m, 0);
    }
    double derivative(const abi::Medium& m, double) const override { return stiffness * m.c0 * m.c0; }
};

SPHONIC_STATE("NAME", Model, "Pressure in proportion to the density change")
)"};

constexpr Text source{"source", R"(/sources=[{"type":"NAME","region":"x < 0","amplitude":50,"omega":50}])",
                      R"(#include <sphonic/plugin/source.hpp>

/// p = amplitude sin(omega (t - x/c0)) along +x, u = p / (rho0 c0).
struct Model final : abi::Source {
    double amplitude = 1, omega = 0;

    static constexpr auto parameters() {
        return std::array{real("amplitude", &Model::amplitude, "Pa", -infinite, infinite, "pressure amplitude"),
                          real("omega", &Model::omega, "rad/s", positive, infinite, "angular frequency")};
    }

    abi::Action action() const override { return {.sets_pressure = true, .sets_velocity_at_start = true}; }
    const abi::PlaneWave* wave() const override { return &emitted; }

    void prepare(const abi::SourceScene& scene) override {
        medium = scene.medium;
        emitted = {.amplitude = amplitude, .omega = omega};
    }

    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        for (int i = 0; i < points.n; ++i) {
            const double p = amplitude * std::sin(omega * (t - points.x[0][i] / medium.c0));
            if (out.p) out.p[i] = p;
            for (int a = 0; a < points.dimension; ++a)
                if (out.u[a]) out.u[a][i] = a == 0 ? p / (medium.rho0 * medium.c0) : 0;
        }
    }

private:
    abi::Medium medium;
    abi::PlaneWave emitted;
};

SPHONIC_SOURCE("NAME", Model, "Plane sine wave along x")
)"};

constexpr Text reference{"reference", R"(/reference={"type":"NAME","region":"0 <= x <= 80","amplitude":50,"omega":50})",
                         R"(#include <sphonic/plugin/reference.hpp>

/// A wave that has always been there: p = amplitude sin(omega (t - x/c0)) along +x, u = p / (rho0 c0).
struct Model final : abi::Reference {
    double amplitude = 1, omega = 0;

    static constexpr auto parameters() {
        return std::array{real("amplitude", &Model::amplitude, "Pa", -infinite, infinite, "pressure amplitude"),
                          real("omega", &Model::omega, "rad/s", positive, infinite, "angular frequency")};
    }

    void prepare(const abi::ReferenceScene& scene) override { medium = scene.medium; }
    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        for (int i = 0; i < points.n; ++i) {
            const double p = amplitude * std::sin(omega * (t - points.x[0][i] / medium.c0));
            if (out.p) out.p[i] = p;
            for (int a = 0; a < points.dimension; ++a)
                if (out.u[a]) out.u[a][i] = a == 0 ? p / (medium.rho0 * medium.c0) : 0;
        }
    }

private:
    abi::Medium medium;
};

SPHONIC_REFERENCE("NAME", Model, "Travelling sine wave along x")
)"};

constexpr Text integrator{"integrator", "/integrator/type=NAME", R"(#include <sphonic/plugin/integrator.hpp>

/// Symplectic Euler: one group after the other, each with the newest values of the others.
struct Model final : abi::Integrator {
    void step(abi::System& system, const abi::Step& now) const override {
        for (abi::Group group = 0; group < system.groups(); ++group) {
            system.advance(group, now.t, now.dt);
            system.settle(group, now.t + now.dt);
        }
    }
    abi::Stagger stagger() const override { return abi::Stagger::behind; }
};

SPHONIC_INTEGRATOR("NAME", Model, "Symplectic Euler: groups in turn")
)"};

constexpr Text arrangement{"arrangement", "/particles/type=NAME", R"(#include <sphonic/plugin/arrangement.hpp>

/// x = lower + i dx, x fastest.
struct Model final : abi::Arrangement {
    bool regular() const override { return true; }
    long size(const abi::Box& box) const override { return box.count[0] * box.count[1] * box.count[2]; }
    void place(const abi::Box& box, double* const x[3]) const override {
        for (long i = 0; i < size(box); ++i) {
            long rest = i;
            for (int a = 0; a < box.dimension; rest /= box.count[a++])
                x[a][i] = box.lower[a] + double(rest % box.count[a]) * box.dx;
        }
    }
};

SPHONIC_ARRANGEMENT("NAME", Model, "Square or cubic lattice")
)"};

constexpr Text boundary{"boundary", R"(/boundaries=[{"type":"NAME","face":"x_max"}])", R"(#include <sphonic/plugin/boundary.hpp>

/// Nothing beyond the last particle.
struct Model final : abi::Boundary {
    abi::Closure closure() const override { return abi::Closure::free; }
};

SPHONIC_BOUNDARY("NAME", Model, "Nothing beyond the last particle")
)"};

constexpr Text shape{"shape", R"(/obstacles=[{"type":"NAME","centre":[1,0.5],"radius":0.2}])", R"(#include <sphonic/plugin/shape.hpp>

/// |x - centre| = radius, in any number of dimensions.
struct Model final : abi::Shape {
    Vector centre;
    double radius = 0;

    static constexpr auto parameters() {
        return std::array{vector("centre", &Model::centre, "m", -infinite, infinite, "the origin if not given"),
                          real("radius", &Model::radius, "m", positive, infinite, "distance of the surface from the centre")};
    }

    void prepare(const abi::ShapeScene&) override {}
    void measure(const abi::Points& points, double* distance, double* const normal[3]) const override {
        for (int i = 0; i < points.n; ++i) {
            double r[3] = {};
            for (int a = 0; a < points.dimension; ++a) r[a] = points.x[a][i] - centre.v[a];
            const double length = std::hypot(r[0], r[1], r[2]);
            distance[i] = length - radius;
            for (int a = 0; a < points.dimension; ++a) normal[a][i] = length > 0 ? r[a] / length : a == 0;
        }
    }
};

SPHONIC_SHAPE("NAME", Model, "A ball")
)", "cases/scenes/pulse_2d.json"};

constexpr Text method{"method", "/method/type=NAME", R"(#include <sphonic/plugin/method.hpp>

/// The runtime's own particles.
struct Model final : abi::Method {
    std::unique_ptr<abi::Solver> discretise(const abi::Scene& scene) const override { return scene.particles(scene.host); }
    bool meshfree() const override { return true; }
};

SPHONIC_METHOD("NAME", Model, "Kernel, equations and integrator of the case")
)"};

constexpr Text all[] = {kernel, viscosity, dissipation, form, state, source, reference, integrator, arrangement, boundary, shape, method};

/// "plane_wave" of the kind "source" is PlaneWaveSource: with the kind it is no name of the plugin headers.
std::string struct_name(const std::string& kind, const std::string& name) {
    std::string out;
    bool begins = true;
    for (const char c : name + "_" + kind) {
        if (c != '_') out += begins ? char(std::toupper(c)) : c;
        begins = c == '_';
    }
    return out;
}

std::string replaced(std::string text, std::string_view what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) text.replace(at, what.size(), by);
    return text;
}

}    // namespace

std::optional<Scaffold> scaffold(const std::string& kind, const std::string& name) {
    for (const Text& text : all) {
        if (text.kind != kind) continue;
        const std::string model = replaced(std::string(text.source), "Model", struct_name(kind, name));
        return Scaffold{.source = replaced(model, "NAME", name), .set = replaced(std::string(text.set), "NAME", name), .scene = std::string(text.scene)};
    }
    return std::nullopt;
}

}    // namespace sphonic::driver
