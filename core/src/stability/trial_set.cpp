#include "trial_set.hpp"

#include <cmath>
#include <random>

#include "scene.hpp"

namespace sphonic {
namespace {

constexpr double size = 1e-8;        ///< of the noise, in units of the medium: what is not linear does not show
constexpr int applications = 300;    ///< of the operator's square, after which the fastest motions are left

/// Even between -1 and 1.
std::vector<double> noise(long n, unsigned seed) {
    std::mt19937_64 bits(seed);
    std::vector<double> x(static_cast<std::size_t>(n));
    for (double& value : x) value = double(bits() >> 11) * 0x1p-52 - 1;
    return x;
}

void normalise(std::vector<double>& x) {
    double sum = 0;
    for (const double value : x) sum += value * value;
    for (double& value : x) value /= std::sqrt(sum / double(x.size()));
}

/// Initial values for a method that asks its scene for them.
bool noisy(const void* host, const char* field, int axis, const abi::Points& points, double* out) {
    const Case& scene = *static_cast<const Case*>(host);
    const bool pressure = *field == 'p';
    const double unit = pressure ? scene.medium.rho0 * scene.medium.c0 * scene.medium.c0 : scene.medium.c0;
    const std::vector<double> x = noise(points.n, pressure ? 1 : 2 + unsigned(axis));
    for (std::size_t i = 0; i < x.size(); ++i) out[i] = size * unit * x[i];
    return true;
}

}    // namespace

void StabilityTrial::Particles::begin(const std::vector<double>& x, double dt) {
    dt_ = dt;
    index_ = 0;
    system_.begin_with(x.data(), size, dt);
    scene_.integrator->begin(system_, dt);
    system_.forget_walls();
}

void StabilityTrial::Particles::start(double dt, unsigned seed) { begin(noise(system_.values(), seed), dt); }

void StabilityTrial::Particles::start_fastest(double dt, unsigned seed) {
    if (fastest_.empty()) {
        fastest_ = noise(system_.values(), seed);
        std::vector<double> rate(fastest_.size());
        for (int i = 0; i < applications; ++i) {
            system_.linear_rate(fastest_.data(), rate.data(), 1);
            system_.linear_rate(rate.data(), fastest_.data(), 1);
            normalise(fastest_);
        }
    }
    begin(fastest_, dt);
}

void StabilityTrial::Particles::step() {
    scene_.integrator->step(system_, {index_, double(index_) * dt_, dt_});
    ++index_;
    system_.close_step(double(index_) * dt_, dt_);
}

StabilityTrial::Other::Other(const Case& scene) : scene_(scene) {}

void StabilityTrial::Other::start(double dt, unsigned) {
    SceneView view(scene_);
    view.scene.initial = noisy;
    solver_ = scene_.method->discretise(view.scene);
    solver_->start(dt);
}

double StabilityTrial::Other::energy() {
    const abi::Snapshot shot = solver_->snapshot();
    const double bulk = scene_.medium.rho0 * scene_.medium.c0 * scene_.medium.c0;
    double sum = 0;
    for (int i = 0; i < shot.points.n; ++i) {
        sum += shot.p[i] * shot.p[i] / (bulk * bulk);
        for (int a = 0; a < shot.points.dimension && shot.u[a]; ++a) sum += std::pow(shot.u[a][i] / scene_.medium.c0, 2);
    }
    return sum;
}

}    // namespace sphonic
