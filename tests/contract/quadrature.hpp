#pragma once
/// Integrals of radial functions, by a composite Gauss rule that is refined until it settles.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <sphonic/plugin/abi/kernel.hpp>

namespace sphonic::contract {

/// Integral of g over [0, length]; g takes a list of points and returns its values there.
/// Panels end at multiples of `knot`, where splines have theirs; each is cut into `parts` five-point Gauss rules,
/// and the number of parts doubles until the result changes by less than 1e-11.
template <class G>
double integral(double length, double knot, int parts, G&& g) {
    const double inner = std::sqrt(5 - 2 * std::sqrt(10. / 7)) / 3, outer = std::sqrt(5 + 2 * std::sqrt(10. / 7)) / 3;
    const double heavy = (322 + 13 * std::sqrt(70.)) / 900, light = (322 - 13 * std::sqrt(70.)) / 900;
    const double node[] = {-outer, -inner, 0, inner, outer}, weight[] = {light, heavy, 128. / 225, heavy, light};

    double result = 0;
    for (const int finest = 1024; parts <= finest; parts *= 2) {
        std::vector<double> x, w;
        for (double a = 0; a < length * (1 - 1e-12); a += knot) {
            const double half = (std::min(a + knot, length) - a) / (2 * parts);
            for (int part = 0; part < parts; ++part)
                for (int k = 0; k < 5; ++k) {
                    x.push_back(a + (2 * part + 1 + node[k]) * half);
                    w.push_back(weight[k] * half);
                }
        }
        const std::vector<double> y = g(x);
        double sum = 0;
        for (std::size_t k = 0; k < x.size(); ++k) sum += w[k] * y[k];
        const bool settled = std::abs(sum - result) < 1e-11;
        result = sum;
        if (settled) break;
    }
    return result;
}

/// Surface of the unit sphere in d dimensions times r^(d-1).
inline double shell(int d, double r) {
    const double pi = std::numbers::pi;
    return d == 1 ? 2 : d == 2 ? 2 * pi * r : 4 * pi * r * r;
}

/// Integral of W over all space.
inline double mass(const abi::Kernel& kernel, int d, double h) {
    return integral(kernel.support() * h, h / 2, 1, [&](const std::vector<double>& r) {
        std::vector<double> y(r.size());
        kernel.evaluate(d, int(r.size()), r.data(), h, y.data(), nullptr);
        for (std::size_t k = 0; k < r.size(); ++k) y[k] *= shell(d, r[k]);
        return y;
    });
}

/// Fourier transform of W(r, h = 1) at wave number k > 0.
inline double transform(const abi::Kernel& kernel, int d, double k) {
    const int parts = 1 + int(k / 4);    // a panel of 1/2 then spans at most two radians
    return integral(kernel.support(), 0.5, parts, [&](const std::vector<double>& r) {
        std::vector<double> y(r.size());
        kernel.evaluate(d, int(r.size()), r.data(), 1, y.data(), nullptr);
        for (std::size_t i = 0; i < r.size(); ++i) {
            const double z = k * r[i];
            y[i] *= shell(d, r[i]) * (d == 1 ? std::cos(z) : d == 2 ? std::cyl_bessel_j(0, z) : std::sin(z) / z);
        }
        return y;
    });
}

}    // namespace sphonic::contract
