#include <sphonic/stability_trial.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "trial_set.hpp"

namespace sphonic {
namespace {

constexpr double enough = 18;             ///< ln of the energy's growth that ends a run; what is stable swings by far less
constexpr long looks = 400;               ///< at the energy, in a run
constexpr double widest = 20;             ///< how far from a guess a limit is looked for
constexpr double first_stride = 0.02;     ///< of the search from a guess; doubles

/// ln of the energy over a run.
struct Record {
    std::vector<double> step, energy;

    double peak(double from, double to) const {
        double highest = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < step.size(); ++i)
            if (step[i] >= from && step[i] <= to) highest = std::max(highest, energy[i]);
        return highest;
    }
    /// Slope of the straight line through the values from a step on (least squares).
    double slope(double from) const {
        double n = 0, x = 0, y = 0, xx = 0, xy = 0;
        for (std::size_t i = 0; i < step.size(); ++i)
            if (step[i] >= from) n += 1, x += step[i], y += energy[i], xx += step[i] * step[i], xy += step[i] * energy[i];
        return n > 1 ? (n * xy - x * y) / (n * xx - x * x) : 0;
    }
    bool blown_up() const { return !(energy.back() - energy.front() < enough); }
};

template <class Set>
Record record(Set& set, long steps) {
    Record record{{0}, {std::log(set.energy())}};
    const long every = std::max(1L, steps / looks);
    for (long i = 1; i <= steps; ++i) {
        set.step();
        if (i % every != 0 && i != steps) continue;
        const double energy = std::log(set.energy());
        if (!std::isfinite(energy)) break;
        record.step.push_back(double(i));
        record.energy.push_back(energy);
        if (record.blown_up()) break;
    }
    return record;
}

}    // namespace

void silence(Case& scene) {
    scene.reference.reset();
    scene.sources.clear();
    scene.initial.clear();
}

StabilityTrial::StabilityTrial(const Case& scene, const Options& options, Report report)
    : scene_(scene), options_(options), report_(std::move(report)) {
    if (scene.method->meshfree())
        set_ = std::make_unique<Particles>(scene);
    else
        set_ = std::make_unique<Other>(scene);
}

StabilityTrial::~StabilityTrial() = default;

StabilityTrial::Run StabilityTrial::run(double dt) {
    set_->start(dt, options_.seed);
    const Record energy = record(*set_, options_.steps);
    const double end = energy.step.back(), unset = double(options_.steps);
    const bool stable = end == unset && energy.peak(0.75 * end, end) < energy.peak(0.25 * end, 0.5 * end) + std::log(2.0);
    const double growth = std::max(0.0, 0.5 * energy.slope(0.5 * end));
    if (report_) {
        char text[60];
        std::snprintf(text, sizeof text, stable ? "stable over %.0f steps" : "grows, seen after %.0f steps", end);
        report_(dt, text);
    }
    return {stable, stable ? growth : std::max(growth, 0.5 * (energy.energy.back() - energy.energy.front()) / end)};
}

double StabilityTrial::growth(double dt, long steps) {
    constexpr long begin = 8;    // of a history
    set_->start_fastest(dt, options_.seed);
    for (long i = 0; i < begin; ++i) set_->step();
    const double growth = 0.5 * record(*set_, steps).slope(0);
    if (report_) {
        char text[60];
        std::snprintf(text, sizeof text, "grows by %.3g a step", growth);
        report_(dt, text);
    }
    return growth;
}

template <class Stable>
StabilityTrial::Limit StabilityTrial::bisect(double guess, Stable stable) {
    double low = 0, high = 0, stride = first_stride;
    int runs = 0;
    const auto try_step = [&](double dt) {
        ++runs;
        const bool good = stable(dt);
        (good ? low : high) = dt;
        return good;
    };
    const bool good = try_step(guess);
    while (low == 0 || high == 0) {
        const double next = good ? low * (1 + stride) : high / (1 + stride);
        if (next > widest * guess) return {.dt = std::numeric_limits<double>::infinity(), .runs = runs};
        if (next < guess / widest) return {.runs = runs};
        try_step(next);
        stride *= 2;
    }
    while (high - low > 2 * options_.precision * low) try_step(0.5 * (low + high));
    return {.dt = 0.5 * (low + high), .precision = (high - low) / (high + low), .runs = runs};
}

StabilityTrial::Limit StabilityTrial::limit(double guess) {
    return bisect(guess, [&](double dt) { return run(dt).stable; });
}

StabilityTrial::Limit StabilityTrial::limit_of_growth(double guess, double exponent) {
    return bisect(guess, [&](double dt) { return scene_.until / dt * growth(dt, options_.steps) <= exponent; });
}

}    // namespace sphonic
