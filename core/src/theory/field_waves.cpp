#include "field_waves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sphonic {
namespace {

std::vector<Complex> transformed(const RepeatedBox& box, const std::vector<double>& f) {
    std::vector<Complex> F(f.begin(), f.end());
    fourier(F, box.count(), -1);
    for (Complex& value : F) value /= double(f.size());
    return F;
}

std::vector<double> powers(const RepeatedBox& box, const FieldWaves& c, double impedance) {
    std::vector<double> power(std::size_t(box.size()), 0.0);
    for (std::size_t i = 0; i < power.size(); ++i) {
        for (const auto& F : c.scalars) power[i] += std::norm(F[i]);
        for (const auto& F : c.u) power[i] += impedance * impedance * std::norm(F[i]);
    }
    return power;
}

}    // namespace

FieldWaves field_waves(const Case& scene, const RepeatedBox& box) {
    FieldWaves c;
    std::vector<double> f;
    for (const InitialField& field : scene.initial) {
        const bool velocity = field.variable == "u";
        if (!scene.method->meshfree() && !velocity && field.variable != "p") continue;
        if (!velocity) c.variables.push_back(scene.equations.find(field.variable));
        for (int a = 0; a < int(field.components.size()); ++a) {
            box.initial(field.variable, velocity ? a : -1, f);
            (velocity ? c.u : c.scalars).push_back(transformed(box, f));
        }
    }
    return c;
}

std::vector<long> strongest(const RepeatedBox& box, const FieldWaves& c, double impedance, double left_out) {
    const std::vector<double> power = powers(box, c, impedance);
    const double enough = (1 - left_out) * std::accumulate(power.begin(), power.end(), 0.0);
    std::vector<long> order;
    const double floor = enough * 1e-3 * left_out / double(power.size());
    for (long i = 0; i < box.size(); ++i)
        if (power[std::size_t(i)] > floor) order.push_back(i);
    std::ranges::sort(order, [&](long a, long b) { return power[std::size_t(a)] > power[std::size_t(b)]; });
    double sum = 0;
    std::size_t kept = 0;
    while (kept < order.size() && sum < enough) sum += power[std::size_t(order[kept++])];
    order.resize(kept);
    std::erase_if(order, [&](long i) { return box.opposite(i) < i; });
    return order;
}

double shortest_wave(const Case& scene, double share) {
    const double pi = std::acos(-1.0), c0 = scene.medium.c0;
    double shortest = std::numeric_limits<double>::infinity();
    for (const SourceUse& use : scene.sources) {
        const double omega = use.source->wave() ? use.source->wave()->omega : use.source->tone();
        if (omega > 0) shortest = std::min(shortest, 2 * pi * c0 / omega);
    }
    if (scene.initial.empty()) return shortest;
    const RepeatedBox box(scene);
    const std::vector<double> power = powers(box, field_waves(scene, box), scene.medium.rho0 * c0);
    std::vector<std::pair<double, double>> by_length;    // |k|, power
    for (long i = 1; i < box.size(); ++i) {
        const auto k = box.wave_vector(i);
        by_length.emplace_back(std::hypot(k[0], k[1], k[2]), power[std::size_t(i)]);
    }
    std::ranges::sort(by_length, std::greater{});
    const double allowed = share * std::accumulate(power.begin(), power.end(), 0.0);
    double sum = 0;
    for (const auto& [k, p] : by_length)
        if ((sum += p) > allowed) return std::min(shortest, 2 * pi / k);
    return shortest;
}

}    // namespace sphonic
