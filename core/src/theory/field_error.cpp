#include "field_error.hpp"

#include <cmath>

#include <sphonic/shown.hpp>
#include <sphonic/stability.hpp>

#include "field_waves.hpp"
#include "mode_system.hpp"

namespace sphonic {
namespace {

constexpr long most_points = 6'000'000, most_waves = 60'000;
constexpr double most_work = 2e9;    ///< of a transform

/// What becomes of one component of the pressure, by the continuous equations or by the scheme.
class Evolution {
public:
    Evolution(const Case& scene, const FieldWaves& given, double dt, long steps) : scene_(scene), given_(given), dt_(dt), steps_(steps) {
        if (scene.method->meshfree()) lattice_.emplace(scene);
    }

    Complex exact(const double* k, long i) const {
        abi::CarriedWave wave;
        double squares = 0;
        for (int a = 0; a < scene_.box.dimension; ++a) squares += k[a] * k[a];
        wave.omega = scene_.medium.c0 * std::sqrt(squares);
        for (int a = 0; a < scene_.box.dimension && squares > 0; ++a) wave.along[a] = k[a] / std::sqrt(squares);
        return carried(wave, i);
    }

    Complex numerical(const double* k, long i) const {
        abi::CarriedWave wave;
        if (!lattice_) return scene_.method->carry(scene_.medium, scene_.box, dt_, k, wave) ? carried(wave, i) : Complex();
        const Symbol A = lattice_->symbol(k, {.viscosity = 0.5});
        ModeSystem mode(scene_, A);
        const Symbol map = mode.run_map(*scene_.integrator, dt_, steps_);
        std::vector<Complex> z(std::size_t(A.n));    // vectors over i
        for (std::size_t s = 0; s < given_.scalars.size(); ++s) {
            const Case::Behind behind = scene_.behind(given_.variables[s]);
            z[std::size_t(mode.row(behind.variable))] += given_.scalars[s][std::size_t(i)] / behind.slope;
        }
        const int u = mode.row(scene_.equations.find("u"));
        for (std::size_t a = 0; a < given_.u.size(); ++a) z[std::size_t(u) + a] = given_.u[a][std::size_t(i)] / Complex(0, 1);
        const Case::Behind p = scene_.behind(scene_.equations.find("p"));
        Complex sum = 0;
        for (int c = 0; c < map.n; ++c) sum += map.a[std::size_t(mode.row(p.variable) * map.n + c)] * z[std::size_t(c)];
        return sum * p.slope;
    }

private:
    const Case& scene_;
    const FieldWaves& given_;
    const double dt_;
    const long steps_;
    std::optional<LatticeOperator> lattice_;

    Complex carried(const abi::CarriedWave& wave, long i) const {
        const double turn = wave.omega * dt_ * double(steps_);
        Complex p = 0, along = 0;
        for (std::size_t s = 0; s < given_.scalars.size(); ++s) p += pressure_slope(given_.variables[s]) * given_.scalars[s][std::size_t(i)];
        for (std::size_t a = 0; a < given_.u.size(); ++a) along += wave.along[a] * given_.u[a][std::size_t(i)];
        return p * std::cos(turn) - Complex(0, scene_.medium.rho0 * scene_.medium.c0) * along * std::sin(turn);
    }
    /// dp over d of a variable from which p comes.
    double pressure_slope(int variable) const {
        if (!scene_.method->meshfree()) return 1;
        return scene_.behind(scene_.equations.find("p")).slope / scene_.behind(variable).slope;
    }
};

std::vector<double> in_space(const RepeatedBox& box, std::vector<Complex> F) {
    fourier(F, box.count(), 1);
    std::vector<double> own;
    for (const long i : box.own()) own.push_back(F[std::size_t(i)].real());
    return own;
}

/// Adds up what differs, in the region of the case's reference.
void compare(const Case& scene, const std::vector<double>& p, const std::vector<double>& exact, FieldError& sum) {
    const std::size_t n = p.size();
    std::vector<double> x[3] = {std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
    double* const at[3] = {x[0].data(), x[1].data(), x[2].data()};
    scene.arrangement->place(scene.box, at);
    for (std::size_t i = 0; i < n; ++i) {
        const double point[3] = {x[0][i], x[1][i], x[2][i]};
        if (scene.reference && scene.reference->region && !scene.reference->region->contains(point)) continue;
        sum.error += (p[i] - exact[i]) * (p[i] - exact[i]);
        sum.power += exact[i] * exact[i];
    }
}

/// What of a case keeps it from being followed wave by wave; empty: nothing.
std::string hindrance(const Case& scene) {
    if (scene.initial.empty() || !scene.sources.empty()) return "it does not begin with initial fields alone";
    if (scene.media->several()) return "it has several media";
    if (!scene.regular()) return "its particles are no whole lattice";
    if (!repeats(scene)) return "it has walls that are no mirrors";
    abi::CarriedWave wave;
    const double k[3] = {1, 0, 0};
    if (!scene.method->meshfree() && !scene.method->carry(scene.medium, scene.box, 1e-9, k, wave)) return "the method does not tell how it carries waves";
    if (scene.equations.find("u") < 0 && scene.method->meshfree()) return "its equations have no u";
    return {};
}

}    // namespace

std::optional<FieldError> field_error(const Case& scene, double dt, long steps, std::string& why, double precision) {
    why = hindrance(scene);
    if (!why.empty()) return {};
    const RepeatedBox box(scene);
    if (box.size() > most_points || fourier_work(box.count()) > most_work) {
        why = "its waves need a box of " + shown(double(box.size())) + " points";
        return {};
    }
    const FieldWaves given = field_waves(scene, box);
    const std::vector<long> waves = strongest(box, given, scene.medium.rho0 * scene.medium.c0, precision * precision);
    if (long(waves.size()) > most_waves) {
        why = "its fields consist of " + shown(double(waves.size())) + " waves";
        return {};
    }
    const Evolution evolution(scene, given, dt, steps);
    std::vector<Complex> numerical(std::size_t(box.size())), exact(numerical);
    for (const long i : waves) {
        const auto k = box.wave_vector(i);
        const double half = box.opposite(i) == i ? 1 : 2;    // with the real part, what its conjugate adds
        numerical[std::size_t(i)] = half * evolution.numerical(k.data(), i);
        exact[std::size_t(i)] = half * evolution.exact(k.data(), i);
    }
    FieldError sum{0, 0, "l2: the " + shown(double(waves.size())) + " strongest waves of the initial fields by the scheme's own map of every step"};
    if (is_viscous(scene)) sum.basis += ", viscosity at half strength";
    if (scene.motion == Motion::lagrangian) sum.basis += ", as if the particles stayed";
    if (box.opened()) sum.basis += ", without what comes back from open or absorbing faces";
    compare(scene, in_space(box, std::move(numerical)), in_space(box, std::move(exact)), sum);
    return sum;
}

}    // namespace sphonic
