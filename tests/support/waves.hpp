#pragma once
/// What waves run along a line of receivers, by least squares.
#include <cmath>
#include <complex>
#include <vector>

#include <sphonic/simulation.hpp>

namespace sphonic::testing {

using Complex = std::complex<double>;

/// Where f changes sign between two arguments, by bisection.
template <class F>
double root_between(double lower, double upper, F f) {
    const bool sign = f(lower) > 0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (lower + upper);
        ((f(middle) > 0) == sign ? lower : upper) = middle;
    }
    return lower;
}

/// Amplitudes of waves that add up to f with the least rest, and the rest's root mean square.
struct Waves {
    std::vector<Complex> amplitude;
    double rest = 0;
};
inline Waves fitted(const std::vector<Complex>& f, const std::vector<std::vector<Complex>>& waves) {
    const std::size_t n = waves.size();
    std::vector<std::vector<Complex>> system(n, std::vector<Complex>(n + 1));    // normal equations
    for (std::size_t r = 0; r < n; ++r)
        for (std::size_t c = 0; c <= n; ++c)
            for (std::size_t i = 0; i < f.size(); ++i) system[r][c] += std::conj(waves[r][i]) * (c < n ? waves[c][i] : f[i]);
    for (std::size_t r = 0; r < n; ++r)
        for (std::size_t other = 0; other < n; ++other) {
            if (other == r) continue;
            const Complex factor = system[other][r] / system[r][r];
            for (std::size_t c = 0; c <= n; ++c) system[other][c] -= factor * system[r][c];
        }
    Waves result;
    for (std::size_t r = 0; r < n; ++r) result.amplitude.push_back(system[r][n] / system[r][r]);
    for (std::size_t i = 0; i < f.size(); ++i) {
        Complex rest = f[i];
        for (std::size_t r = 0; r < n; ++r) rest -= result.amplitude[r] * waves[r][i];
        result.rest += std::norm(rest) / double(f.size());
    }
    result.rest = std::sqrt(result.rest);
    return result;
}

/// The complex amplitude of p = Re(P exp(i omega t)) of each probe, over the samples from `begin` on.
inline std::vector<Complex> demodulated(const ProbeRecord& probes, double omega, double begin) {
    std::vector<Complex> amplitudes;
    for (const auto& p : probes.p) {
        std::vector<Complex> f;
        std::vector<std::vector<Complex>> tones(2);
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (probes.t[i] < begin) continue;
            f.push_back(p[i]);
            tones[0].push_back(std::polar(1.0, omega * probes.t[i]));
            tones[1].push_back(std::conj(tones[0].back()));
        }
        amplitudes.push_back(2.0 * fitted(f, tones).amplitude[0]);
    }
    return amplitudes;
}

/// Amplitudes of the waves exp(-i k x) for each k, along the probes.
inline Waves along_x(const ProbeRecord& probes, double omega, double begin, const std::vector<double>& k) {
    std::vector<std::vector<Complex>> waves(k.size());
    for (const auto& x : probes.read_at)
        for (std::size_t w = 0; w < k.size(); ++w) waves[w].push_back(std::polar(1.0, -k[w] * x[0]));
    return fitted(demodulated(probes, omega, begin), waves);
}

}    // namespace sphonic::testing
