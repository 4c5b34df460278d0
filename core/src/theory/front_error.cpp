#include "front_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <sphonic/prediction.hpp>

#include "fourier.hpp"

namespace sphonic {
namespace {

const double pi = std::acos(-1.0);

/// Wave number and decay [1/m] of the travelling wave of each frequency.
class Dispersion {
public:
    struct Wave {
        double k = 0, decay = 0;
        bool travels = false;
    };

    Dispersion(const Case& scene, const double* direction, double dt) : c0_(scene.medium.c0) {
        constexpr int samples = 300;
        double steepest = 0;
        for (int a = 0; a < scene.box.dimension; ++a) steepest = std::max(steepest, std::abs(direction[a]));
        for (int i = 1; i < samples; ++i) {
            const double k = pi / (scene.box.dx * steepest) * i / samples;
            const TravellingMode mode = travelling_mode(scene, k, direction, dt, {.viscosity = 0.5});
            if (!rows_.empty() && mode.omega <= rows_.back().omega) break;
            rows_.push_back({mode.omega, c0_ * k / mode.omega, mode.decay / (c0_ * mode.omega * mode.omega)});
        }
    }

    /// Even functions of omega, between two samples straight lines over its square.
    Wave at(double omega) const {
        if (rows_.empty() || omega > rows_.back().omega) return {};
        const auto above = std::ranges::lower_bound(rows_, omega, {}, &Row::omega);
        const Row &b = above == rows_.begin() ? rows_[1] : *above, &a = above == rows_.begin() ? rows_[0] : *std::prev(above);
        const double share = (omega * omega - a.omega * a.omega) / (b.omega * b.omega - a.omega * a.omega);
        const auto between = [&](double lower, double upper) { return lower + share * (upper - lower); };
        return {omega / c0_ * between(a.slowness, b.slowness), omega * omega * between(a.decay, b.decay), true};
    }

private:
    struct Row {
        double omega, slowness, decay;    ///< c0 k / omega, and decay per metre over omega^2
    };
    double c0_;
    std::vector<Row> rows_;
};

/// The places of a case's particles.
struct Places {
    std::size_t n;
    std::vector<double> x[3];

    explicit Places(const Case& scene) : n(std::size_t(scene.arrangement->size(scene.box))) {
        for (auto& coordinate : x) coordinate.resize(n);
        double* const at[3] = {x[0].data(), x[1].data(), x[2].data()};
        scene.arrangement->place(scene.box, at);
    }
    abi::Points points(int dimension) const { return {dimension, int(n), {x[0].data(), x[1].data(), x[2].data()}}; }
    /// Along a wave's direction, from its origin [m].
    double along(const abi::PlaneWave& wave, std::size_t i) const {
        double s = 0;
        for (int a = 0; a < 3; ++a) s += wave.direction[a] * (x[a][i] - wave.origin[a]);
        return s;
    }
    double farthest(const abi::PlaneWave& wave) const {
        double most = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < n; ++i) most = std::max(most, along(wave, i));
        return most;
    }
};

/// Where along its direction a source ends: between its last point and the next, where its wave is least at t = 0 [m from the origin].
double edge_of(const Case& scene, const SourceUse& use, const Places& places) {
    const abi::PlaneWave& wave = *use.source->wave();
    std::vector<unsigned char> inside(places.n);
    use.inside(places.points(scene.box.dimension), inside.data());
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < places.n; ++i)
        if (inside[i]) last = std::max(last, places.along(wave, i));
    const double half = pi * scene.medium.c0 / wave.omega, zero = half * std::ceil(last / half - 1e-9);    // where sin(k s) = 0
    return std::min(zero, last + scene.box.dx);
}

/// Fourier coefficients, for t over `period`, of what the edge sends: the wave from t = 0 on, faded out after `until`.
std::vector<Complex> spectrum_of(const Case& scene, const abi::PlaneWave& wave, double edge, double period, long n) {
    std::vector<Complex> signal(std::size_t(n), Complex{});
    for (long i = 0; i < n; ++i) {
        const double t = period * double(i) / double(n), late = std::clamp((t / scene.until - 1.1) / 0.4, 0.0, 1.0);
        signal[std::size_t(i)] = wave.pressure(wave.omega * (t - edge / scene.medium.c0)) * 0.5 * (1 + std::cos(pi * late)) / double(n);
    }
    signal[0] *= 0.5;    // the middle of a jump
    fourier(signal, {n, 1, 1}, -1);
    return signal;
}

/// Of the signal that an edge sends, four to a spacing.
double samples_of(const Case& scene) { return 4 * 2.5 * scene.until * scene.medium.c0 / scene.box.dx; }

/// A wave that its source has sent by `until`.
class Front {
public:
    Front(const Case& scene, const SourceUse& use, const Places& places, double dt)
        : wave_(*use.source->wave()), c0_(scene.medium.c0), until_(scene.until), ds_(scene.box.dx), edge_(edge_of(scene, use, places)),
          error_(std::size_t(std::clamp((places.farthest(wave_) - edge_) / ds_, 0.0, 1.1 * c0_ * until_ / ds_)) + 20) {
        const double period = 2.5 * until_;
        long n = 64;
        while (double(n) < samples_of(scene)) n *= 2;
        const std::vector<Complex> spectrum = spectrum_of(scene, wave_, edge_, period, n);
        const Dispersion dispersion(scene, wave_.direction, dt);
        for (long m = 0; m < n / 4; ++m) {
            const double omega = 2 * pi * double(m) / period;
            if (omega > pi * c0_ / ds_) break;    // shorter waves are not seen on the lattice
            add(omega, (m == 0 ? 1.0 : 2.0) * spectrum[std::size_t(m)], m == 0 ? Dispersion::Wave{0, 0, true} : dispersion.at(omega));
        }
    }

    double exact(double s) const {
        const double t = until_ - (s - edge_) / c0_;
        return t < 0 ? 0 : wave_.pressure(wave_.omega * (t - edge_ / c0_));
    }
    /// What the run has wrong; nothing within the source.
    double error(double s) const {
        const double place = (s - edge_) / ds_;
        if (place < 0 || place + 1 >= double(error_.size())) return 0;
        const std::size_t i = std::size_t(place);
        return error_[i] + (place - double(i)) * (error_[i + 1] - error_[i]);
    }
    const abi::PlaneWave& wave() const { return wave_; }

private:
    const abi::PlaneWave& wave_;
    const double c0_, until_, ds_, edge_;
    std::vector<double> error_;    ///< at whole spacings from the edge

    void add(double omega, Complex begin, const Dispersion::Wave& w) {
        const Complex step = std::polar(std::exp(-w.decay * ds_), -w.k * ds_), true_step = std::polar(1.0, -omega / c0_ * ds_);
        Complex exact = begin * std::polar(1.0, omega * until_), numerical = w.travels ? exact : Complex{};
        for (double& e : error_) {
            e += (numerical - exact).real();
            numerical *= step;
            exact *= true_step;
        }
    }
};

}    // namespace

std::optional<double> fronts_error(const Case& scene, const std::vector<const SourceUse*>& senders, double dt) {
    constexpr double most_samples = 1 << 18;    // of a run that takes a second or two to foresee
    if (samples_of(scene) > most_samples) return std::nullopt;
    const Places places(scene);
    std::vector<Front> fronts;
    for (const SourceUse* use : senders) fronts.emplace_back(scene, *use, places, dt);
    double error = 0, power = 0;
    for (std::size_t i = 0; i < places.n; ++i) {
        const double point[3] = {places.x[0][i], places.x[1][i], places.x[2][i]};
        if (scene.reference && scene.reference->region && !scene.reference->region->contains(point)) continue;
        double e = 0, p = 0;
        for (const Front& front : fronts) {
            const double s = places.along(front.wave(), i);
            e += front.error(s);
            p += front.exact(s);
        }
        error += e * e;
        power += p * p;
    }
    return std::sqrt(error / power);
}

}    // namespace sphonic
