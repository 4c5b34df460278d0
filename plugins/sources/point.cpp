#include <sphonic/plugin/source.hpp>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

/// A monopole of volume flow Q(t) = flow f(t), in m^3/s (2-D: m^2/s, a line's per metre; 1-D: m/s, a plane's per square metre):
///   dp/dt = ... + rho0 c0^2 Q(t) S(x),   S = exp(-r^2/a^2) / (pi^(1/2) a)^d,
/// which radiates rho0 c0 Q(t - r/c0) / 2 in 1-D and rho0 Q'(t - r/c0) / (4 pi r) in 3-D.
/// The footprint S keeps the short waves that the set carries wrongly, the sawtooth of collocated sets above all, silent.
/// What its transform exp(-k^2 a^2/4) takes from the signal is given back: to a tone at the set's own wave number, along
/// with what the set's response there differs from the medium's; to the pulses, which stay in their family, by a shorter
/// duration: tau'^2 = tau^2 - (a/c0)^2. So the field outside the footprint is that of a point.
struct PointSource final : abi::Source {
    std::string signal = "sine";
    Vector position;
    double flow = 1, omega = 0, duration = 0, delay = 0, swell = 2, width_over_dx = 2.8;

    static constexpr auto parameters() {
        using S = PointSource;
        return std::array{
            text("signal", &S::signal, "sine|gaussian|ricker", "f(t): a tone sin(omega t), exp(-s^2), or (1 - 2 s^2) exp(-s^2), s = (t - delay)/duration"),
            vector("position", &S::position, "m", -infinite, infinite, "where it is; the origin if not given"),
            real("flow", &S::flow, "m^d/s", -infinite, infinite, "volume flow at the signal's height 1"),
            real("omega", &S::omega, "rad/s", 0, infinite, "angular frequency of a sine"),
            real("swell", &S::swell, "1", 0, 1000, "periods over which a sine swells to its full height"),
            real("duration", &S::duration, "s", 0, infinite, "of a pulse; a ricker's spectrum is highest at 2/duration"),
            real("delay", &S::delay, "s", 0, infinite, "time of a pulse's peak; 0 is five durations, a quiet beginning"),
            real("width_over_dx", &S::width_over_dx, "1", 1.5, 20, "radius a of the footprint over the particle spacing")};
    }

    abi::Action action() const override { return {.adds = true}; }

    void prepare(const abi::SourceScene& given) override {
        scene = given;
        if (position.size != 0 && position.size != scene.dimension)
            throw std::invalid_argument("position needs one component per dimension");
        scene.medium = scene.media.at(scene.dimension, position.v, scene.medium);
        a = width_over_dx * scene.media.spacing_at(scene.dimension, position.v, scene.box.dx);
        const bool sine = signal == "sine";
        if (sine ? omega == 0 : duration == 0)
            throw std::invalid_argument("signal \"" + signal + "\" needs " + (sine ? "omega" : "duration") + ", greater than 0");
        if (sine ? duration > 0 || delay > 0 : omega > 0)
            throw std::invalid_argument("signal \"" + signal + "\" does not use " + (sine ? "duration and delay" : "omega") + ": leave it out");
        sine ? match({omega / scene.medium.c0, 1}) : shorten();
    }

    double tone() const override { return signal == "sine" ? omega : 0; }

    /// |Q(omega)| is exp(-y) of a Gaussian and y exp(1 - y) of a Ricker pulse, y = (omega duration / 2)^2, over the largest: a tenth at
    double highest_frequency() const override {
        constexpr double gaussian_y = 2.3026, ricker_y = 4.8897;
        return signal == "sine" ? omega : 2 / duration * std::sqrt(signal == "gaussian" ? gaussian_y : ricker_y);
    }

    void match(const abi::ToneResponse& response) override {
        const double exponent = 0.25 * response.wave_number * response.wave_number * a * a;
        if (exponent > most_exponent) refuse(2 * pi / response.wave_number, "wavelength");
        height = std::exp(exponent) / response.gain;
    }

    void reach(const abi::Points& points, unsigned char* inside) const override {
        for (int i = 0; i < points.n; ++i) inside[i] = distance2(points, i) < cutoff * cutoff * a * a;
    }

    void enlist(const abi::Points& members, double volume) override {
        double sum = 0;
        for (int i = 0; i < members.n; ++i) sum += std::exp(-distance2(members, i) / (a * a));
        unit = 1 / (sum * volume);
    }

    void evaluate(double t, const abi::Points& points, const abi::AcousticField& out) const override {
        for (double* u : out.u)
            if (u) std::fill(u, u + points.n, 0.0);
        if (!out.p) return;
        const auto& m = scene.medium;
        const double rate = m.rho0 * m.c0 * m.c0 * flow * value(t) * unit, inverse = 1 / (a * a);
        for (int begin = 0; begin < points.n; begin += block) {
            const int n = std::min(block, points.n - begin);
            double r2[block];
            for (int i = 0; i < n; ++i) r2[i] = distance2(points, begin + i);
#pragma omp simd
            for (int i = 0; i < n; ++i) r2[i] = rate * exp(-inverse * r2[i]);
            std::copy(r2, r2 + n, out.p + begin);
        }
    }

private:
    static constexpr double cutoff = 4;            ///< of the footprint over a: exp(-16) = 1e-7
    static constexpr double most_exponent = 4;     ///< a tone is raised by no more than exp(4)
    static constexpr double quiet_durations = 5;
    static constexpr int block = 256;
    abi::SourceScene scene;
    double a = 0;           ///< radius of the footprint [m]
    double unit = 0;        ///< 1 / sum V exp(-r^2/a^2)
    double height = 1;      ///< factor of the signal
    double shorter = 0;     ///< tau' [s]

    /// To the nearest image.
    double distance2(const abi::Points& points, int i) const {
        double sum = 0;
        for (int axis = 0; axis < points.dimension; ++axis) {
            double d = points.x[axis][i] - position.v[axis];
            const double length = scene.box.upper[axis] - scene.box.lower[axis];
            if (scene.box.periodic[axis]) d -= length * std::nearbyint(d / length);
            sum += d * d;
        }
        return sum;
    }

    void shorten() {
        const double crossing = a / scene.medium.c0;
        if (duration < 1.2 * crossing) refuse(duration * scene.medium.c0, "pulse");
        shorter = std::sqrt(duration * duration - crossing * crossing);
        const double ratio = duration / shorter;
        height = signal == "gaussian" ? ratio : ratio * ratio * ratio;
        if (delay == 0) delay = quiet_durations * duration;
    }

    double value(double t) const {
        if (signal == "sine") return height * abi::swelling(omega * t, swell) * std::sin(omega * t);
        const double s = (t - delay) / shorter;
        return height * std::exp(-s * s) * (signal == "ricker" ? 1 - 2 * s * s : 1);
    }

    [[noreturn]] void refuse(double length, const std::string& what) const {
        std::ostringstream text;
        text.precision(3);
        text << "its " << what << " is " << length << " m long on this set, too short for a footprint of radius " << a << " m (width_over_dx "
             << width_over_dx << "): choose a smaller dx or a longer " << what;
        throw std::invalid_argument(text.str());
    }
};

SPHONIC_SOURCE("point", PointSource, "A monopole: volume flow at a point, as a tone, a Gaussian or a Ricker pulse")
